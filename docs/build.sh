#!/bin/sh
# Builds the documentation as one static site, on a fresh Debian or Ubuntu too:  sh docs/build.sh
#
# build/docs/html/index.html: the README, the guides, a page for each law, and the reference of all headers, with a search.
# A warning of Doxygen is an error.
set -eu
case ${1:-} in
-h | --help)
  sed -n '1d; /^#/!q; s/^# \{0,1\}//p' "$0"
  exit 0
  ;;
'') ;;
*)
  echo "docs/build.sh: $1 is not --help" >&2
  exit 2
  ;;
esac
cd "$(dirname "$0")/.."

# shellcheck source=cmake/install_packages.sh
. cmake/install_packages.sh
install_packages g++ libeigen3-dev nlohmann-json3-dev doxygen git python3 python3-matplotlib

out=build/docs
mkdir -p $out
g++ -std=c++17 -O1 -DCONTACTLAWS_INLINE=inline -DCONTACTLAWS_NO_EIGEN -Iinclude -Iexamples docs/site/laws.cpp -o $out/laws
$out/laws > $out/laws.json
# The first Python that has matplotlib: Debian's package serves /usr/bin/python3, which need not be the first on the path.
for python in python3 /usr/bin/python3; do
  if "$python" -c 'import matplotlib' 2> /dev/null; then break; fi
done
"$python" docs/site/pages.py $out/laws.json $out
# Doxygen's own layout, with the laws and the guides in the menu.
doxygen -l $out/layout.xml
sed -i 's|\( *\)<tab type="pages".*|\1<tab type="user" url="@ref laws" title="Laws"/>\n\1<tab type="user" url="@ref md_docs_README" title="Guides"/>\n&|' \
  $out/layout.xml
doxygen docs/site/Doxyfile
if [ -s $out/warnings.txt ]; then
  cat $out/warnings.txt >&2
  exit 1
fi
echo "$out/html/index.html"
