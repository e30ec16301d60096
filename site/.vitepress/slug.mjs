/** Returns the anchor that GitHub gives to a heading. Links in the documentation use GitHub's anchors. */
export function slugOf(heading) {
  return heading
    .trim()
    .toLowerCase()
    .replace(/[^\p{L}\p{N}\p{M}_ -]/gu, '')
    .replaceAll(' ', '-')
}
