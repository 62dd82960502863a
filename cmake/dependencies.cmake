# Every library comes from a Debian 12 package (script/packages.txt); nothing is downloaded. What is missing is named
# all at once, with the command that installs it.
set(missing_packages)

# goniolux_find(libfmt-dev fmt 9 CONFIG): the Debian package, then the arguments of find_package.
macro(goniolux_find debian_package name)
  find_package(${name} ${ARGN} QUIET)
  if(NOT ${name}_FOUND)
    list(APPEND missing_packages ${debian_package})
  endif()
endmacro()

# goniolux_find_module(liblcms2-dev LCMS2 lcms2): target PkgConfig::LCMS2.
macro(goniolux_find_module debian_package name module)
  if(PkgConfig_FOUND)
    pkg_check_modules(${name} QUIET IMPORTED_TARGET ${module})
  endif()
  if(NOT ${name}_FOUND)
    list(APPEND missing_packages ${debian_package})
  endif()
endmacro()

goniolux_find(libembree-dev embree 3.13 CONFIG)
goniolux_find(libglm-dev glm CONFIG)
goniolux_find(libopenexr-dev OpenEXR 3.1 CONFIG)
goniolux_find(libfmt-dev fmt 9 CONFIG)
goniolux_find(libcli11-dev CLI11 CONFIG)
goniolux_find(libpugixml-dev pugixml CONFIG)
goniolux_find(libassimp-dev assimp 5.2 CONFIG)
goniolux_find(libpng-dev PNG)
goniolux_find(libtiff-dev TIFF)
goniolux_find(libjpeg-dev JPEG)
goniolux_find(g++ Threads)
goniolux_find(libssl-dev OpenSSL 3 COMPONENTS Crypto)
goniolux_find(pkg-config PkgConfig)
goniolux_find_module(libjsoncpp-dev JSONCPP jsoncpp)
goniolux_find_module(liblcms2-dev LCMS2 lcms2)
goniolux_find_module(libegl-dev EGL egl)
goniolux_find(qtbase5-dev Qt5 5.15 COMPONENTS Widgets Test)
goniolux_find(libgtest-dev GTest CONFIG)
goniolux_find(libbenchmark-dev benchmark CONFIG)

if(missing_packages)
  list(JOIN missing_packages " " missing_packages)
  message(FATAL_ERROR "Missing Debian packages: ${missing_packages}\n"
                      "Install all that is needed with: script/setup")
endif()
