/** markdown-it plugin: renders indented code blocks like fenced ones, so that both scroll. */
export function indentedCode(markdown) {
  markdown.core.ruler.push('furrow-indented-code', ({ tokens }) => {
    for (const token of tokens)
      if (token.type === 'code_block') Object.assign(token, { type: 'fence', info: 'text' })
  })
}
