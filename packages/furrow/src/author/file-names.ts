/** Maximum length in UTF-8 bytes. Encrypted folders (eCryptfs) allow 143 bytes, which must also hold an extension and a temporary suffix. */
const MAX_BYTES = 100

/** Characters that some file system or shell rejects or hides: reserved and invisible characters, and dots or spaces at either end. */
const UNSAFE = /[<>:"/\\|?*\p{Cc}\p{Cf}\p{Cs}\p{Cn}\p{Zl}\p{Zp}]|^[ .]+|[ .]+$/gu

/** Reserved device names on Windows, with any extension. */
const DEVICE = /^(con|prn|aux|nul|conin\$|conout\$|(com|lpt)[0-9¹²³])(?=\.|$)/i

/**
 * Derives file names without extension from layer or area names. The file names are valid on every file system, and stay distinct on file
 * systems that ignore case or Unicode normalisation. A valid name stays unchanged, unless it collides with an earlier valid
 * name.
 *
 * @param names distinct names of any characters.
 * @returns one file name per name: at most 100 bytes in UTF-8, plus a number if needed to make it unique.
 */
export function fileNamesOf(names: readonly string[]): string[] {
  const taken = new Set<string>()
  const fileNames = [...names]
  const take = (index: number) => {
    const wanted = safeName(names[index])
    let unique = wanted
    for (let n = 2; taken.has(folded(unique)); n++) unique = `${wanted}-${n}`
    taken.add(folded(unique))
    fileNames[index] = unique
  }
  // Assign valid names first, so that they stay unchanged. `pack` finds a layer's maps by the layer's name.
  const changed: number[] = []
  for (const [i, name] of names.entries()) {
    if (isFileName(name) && !taken.has(folded(name))) take(i)
    else changed.push(i)
  }
  for (const i of changed) take(i)
  return fileNames
}

/** Returns whether a name is a valid file name, without extension, on every file system. */
export function isFileName(name: string): boolean {
  return name !== '' && safeName(name) === name.normalize('NFC')
}

function safeName(name: string): string {
  const plain = name.normalize('NFC').replaceAll(UNSAFE, '_').replace(DEVICE, '$&_')
  const short = shortened(plain)
  return short === plain ? plain : short.replace(/[ .]+$/, '_')
}

/** Truncates to the maximum length without splitting a character. */
function shortened(text: string): string {
  const encoder = new TextEncoder()
  let [length, bytes] = [0, 0]
  for (const character of text) {
    bytes += encoder.encode(character).length
    if (bytes > MAX_BYTES) break
    length += character.length
  }
  return text.slice(0, length)
}

/** Returns a key that is the same for all names that some file system treats as equal. */
function folded(name: string): string {
  return name.normalize('NFKC').toUpperCase().toLowerCase()
}
