/**
 * Yields the lines of a text file, without byte order mark and line endings (`\n`, `\r\n` or `\r`).
 *
 * @param longest number of characters to keep in memory. A line that is longer may be split.
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
      // Keep a final `\r` for the next chunk, which may begin with `\n`.
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
