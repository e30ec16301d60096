/** markdown-it plugin that renders indented code blocks like fenced code blocks, so that long lines scroll in both. */
export function indentedCode(markdown) {
  markdown.core.ruler.push('furrow-indented-code', ({ tokens }) => {
    for (const token of tokens)
      if (token.type === 'code_block') Object.assign(token, { type: 'fence', info: 'text' })
  })
}
