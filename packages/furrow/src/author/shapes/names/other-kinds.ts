import type { ShapeKind } from './name-hint.ts'

/** Words in the names of blendshapes that are not expressions, and the kind of these blendshapes. The first match wins. */
const WORDS: readonly (readonly [ShapeKind, RegExp])[] = [
  ['hidden', /(^|[^a-z])(hide|hidden|hides|shrink|shrunk|invisible|vanish)([^a-z]|$)|非表示|消し|隠/i],
  [
    'corrective',
    /(^|[^a-z])(corrective|correction|corr|fix|combo|combination|inbetween|p?jcm|p?mcm|cbs|flexion)([^a-z]|$)|^pJCM|^pMCM/i,
  ],
  [
    'body',
    /(^|[^a-z])(male|female|gender|fat|fatness|thin|slim|heavy|muscle|muscular|muscles|weight|height|tall|age|aged|old|young|body|belly|breasts?|bust|chest|waist|hips?|butt|thighs?|legs?|arms?|shoulders?|masculine|feminine|pregnant)([^a-z]|$)|胸|体型/i,
  ],
]

/** Returns the kind of a blendshape by the words in its name; undefined if no word is known. */
export function kindByWords(name: string): ShapeKind | undefined {
  const spaced = name.replace(/(\p{Ll})(\p{Lu})/gu, '$1_$2')
  return WORDS.find(([, words]) => words.test(name) || words.test(spaced))?.[0]
}
