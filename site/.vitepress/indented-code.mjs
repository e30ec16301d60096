/** A plugin of markdown-it: code that is indented looks, and is scrolled, like code between fences. */
export function indentedCode(markdown) {
  markdown.core.ruler.push('furrow-indented-code', ({ tokens }) => {
    for (const token of tokens)
      if (token.type === 'code_block') Object.assign(token, { type: 'fence', info: 'text' })
  })
}
