/**
 * Streams the lines of a text file, without line endings (`\n`, `\r\n` or `\r`) and byte order mark.
 *
 * @param longest characters after which a line is split.
 */
export async function* linesOf(file: Blob, longest: number): AsyncGenerator<string> {
  const decoder = new TextDecoder()
  const reader = file.stream().getReader()
  let rest = ''
  try {
    for (let isLast = false; !isLast; ) {
      const { done, value } = await reader.read()
      isLast = done
      const text = rest + decoder.decode(value, { stream: !done })
      // The next chunk may begin with the `\n` of this `\r`.
      const lines = text.split(/\r\n|\n|\r(?!$)/)
      rest = isLast ? '' : lines.pop()!
      yield* lines
      if (rest.length < longest) continue
      yield rest
      rest = ''
    }
  } finally {
    // Release the file if the caller stops early.
    await reader.cancel()
  }
}
