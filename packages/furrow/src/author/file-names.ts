/** Most bytes in UTF-8: with an extension and a temporary suffix, a name stays within the 143 of encrypted folders. */
const MOST_BYTES = 100

/** What some file system or shell refuses or hides: reserved characters, invisible ones, and dots or spaces at either end. */
const UNSAFE = /[<>:"/\\|?*\p{Cc}\p{Cf}\p{Cs}\p{Cn}\p{Zl}\p{Zp}]|^[ .]+|[ .]+$/gu

/** Names of devices on Windows, with any extension. */
const DEVICE = /^(con|prn|aux|nul|conin\$|conout\$|(com|lpt)[0-9¹²³])(?=\.|$)/i

/**
 * Derives the names of files, without extension, from the names of layers or areas: valid on every file system, and different even where
 * case and Unicode normalisation are ignored. A name that is one already is kept. The order of the names matters only where two would be
 * the same.
 *
 * @param names distinct names of any characters.
 * @returns one name for each: at most 100 bytes in UTF-8, or some more where a number makes it unique.
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
  // A folder that is packed again looks for the maps of a layer under its name: no other layer may take that.
  const changed: number[] = []
  for (const [i, name] of names.entries()) {
    if (isFileName(name) && !taken.has(folded(name))) take(i)
    else changed.push(i)
  }
  for (const i of changed) take(i)
  return fileNames
}

/** Whether a name is the name of a file, without extension, on every file system; only then can a file be its only record. */
export function isFileName(name: string): boolean {
  return name !== '' && safeName(name) === name.normalize('NFC')
}

function safeName(name: string): string {
  const plain = name.normalize('NFC').replaceAll(UNSAFE, '_').replace(DEVICE, '$&_')
  const short = shortened(plain)
  return short === plain ? plain : short.replace(/[ .]+$/, '_')
}

/** As many whole characters as fit. */
function shortened(text: string): string {
  const encoder = new TextEncoder()
  let [length, bytes] = [0, 0]
  for (const character of text) {
    bytes += encoder.encode(character).length
    if (bytes > MOST_BYTES) break
    length += character.length
  }
  return text.slice(0, length)
}

/** Equal for names that some file system takes for the same. */
function folded(name: string): string {
  return name.normalize('NFKC').toUpperCase().toLowerCase()
}
