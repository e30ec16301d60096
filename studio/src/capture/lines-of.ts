/**
 * The lines of a text file as it is read, without their ends (`\n`, `\r\n` or `\r`) and without a byte order mark.
 *
 * @param longest characters of a line; one that is longer is given in pieces of at least that many.
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
      // A line that ends in `\r` may go on with `\n`.
      const lines = text.split(/\r\n|\n|\r(?!$)/)
      rest = isLast ? '' : lines.pop()!
      yield* lines
      if (rest.length < longest) continue
      yield rest
      rest = ''
    }
  } finally {
    // Where nobody asks for the others.
    await reader.cancel()
  }
}
