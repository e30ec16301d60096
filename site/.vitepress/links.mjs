import { fileOf, targetOf } from '../places.mjs'

const OUTSIDE = /^(?:[a-z]+:|\/|#)/i

/**
 * A plugin of markdown-it: links between files of the repository become links of the site. What the site does not have is linked in the
 * repository, or is plain text where nobody knows its address.
 */
export function repositoryLinks(markdown) {
  markdown.core.ruler.push('furrow-links', ({ tokens, env }) => {
    const page = env.relativePath
    if (page === undefined || isGenerated(page)) return
    for (const { children } of tokens) if (children) rewrite(children, fileOf(page))
  })
}

/** Pages that no file of the repository became; they link to pages only. */
const isGenerated = (page) => page === 'index.md' || /^(commands|examples)\//.test(page)

function rewrite(tokens, file) {
  for (const [i, token] of tokens.entries()) {
    const href = token.type === 'link_open' ? token.attrGet('href') : null
    if (href === null || OUTSIDE.test(href)) continue
    const target = targetOf(file, decodeURI(href))
    if (target) {
      token.attrSet('href', target.href)
      // The router of the pages knows nothing else.
      if (target.leaves) token.attrSet('target', '_self')
    } else {
      toText(token)
      toText(tokens.slice(i).find(({ type }) => type === 'link_close'))
    }
  }
}

function toText(token) {
  Object.assign(token, { type: 'text', tag: '', content: '', nesting: 0 })
}
