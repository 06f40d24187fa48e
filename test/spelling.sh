#!/usr/bin/env bash
# test/spelling.sh [FILE...]: looks in all tracked text files, or only those given, and in their
# names, for common misspellings, for British words (test/spelling/british.txt; the words within
# names_like_this and LikeThis, too) and for phrases to avoid (phrases.txt), and says what to write.
# allowed_words.txt has words that are right although codespell doubts them, and allowed_names.txt
# names that others have chosen.
set -euo pipefail
files=()
for file in "$@"; do
  files+=("$(realpath --relative-base="$(git -C "$(dirname "$0")" rev-parse --show-toplevel)" "$file")")
done
cd "$(dirname "$0")/.."
git rev-parse --verify --quiet HEAD >/dev/null || {
  echo "git cannot read this folder" >&2
  exit 1
}

mapfile -d '' -t files < <(git ls-files -z -- "${files[@]}" | grep -zvE \
  -e '^(LICENSE\.md|doc/cgal\.tag|test/spelling/.*\.txt|.*/package-lock\.json)$' -e '\.(png|jpg|pdf)$')
[ ${#files[@]} -gt 0 ] || exit 0

failed=0

# escape sequences are no parts of words: "\nd" is not a word "nd"
ignored=$(grep -v '^#' test/spelling/allowed_names.txt | paste -sd '|')
codespell --disable-colors --check-filenames \
  --regex "[A-Z]?[a-z]+(?:['’][a-z]+)?|[A-Z]+(?![a-z])" \
  --ignore-regex "$ignored|\\\\[nrtv0f]" \
  --ignore-words test/spelling/allowed_words.txt \
  --builtin clear,rare,en-GB_to_en-US -D - -D test/spelling/british.txt \
  "${files[@]}" || failed=1

perl -e '
  my @phrases;
  open(my $list, "<", "test/spelling/phrases.txt") or die;
  while (<$list>) {
    next if /^#/;
    chomp;
    my ($phrase, $advice) = split / -> /, $_, 2;
    $phrase =~ s{ }{(?:\\s|\\n\\s*(?://[/!]*|\\*|#))+}g;
    push @phrases, [qr/\b(?:$phrase)\b/i, $advice];
  }
  my $found = 0;
  for my $name (@ARGV) {
    open(my $file, "<", $name) or die "$name: $!\n";
    my $text = do { local $/; <$file> };
    for my $phrase (@phrases) {
      my ($pattern, $advice) = @$phrase;
      while ($text =~ /$pattern/g) {
        my $line = 1 + (substr($text, 0, $-[0]) =~ tr/\n//);
        my $words = $& =~ s/[\s\/#*!]+/ /gr;
        print "$name:$line: $words ==> $advice\n";
        $found = 1;
      }
    }
  }
  exit $found' "${files[@]}" || failed=1

exit $failed
