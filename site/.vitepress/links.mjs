import { fileOf, resolveLink } from '../places.mjs'

const OUTSIDE = /^(?:[a-z]+:|\/|#)/i

/**
 * markdown-it plugin that adapts links between files of the repository. A link to a file that is a page leads to the
 * page. Links to other files lead to the repository. If package.json names no repository, these links become plain
 * text.
 */
export function repositoryLinks(markdown) {
  markdown.core.ruler.push('furrow-links', ({ tokens, env }) => {
    const page = env.relativePath
    if (page === undefined || isGenerated(page)) return
    for (const { children } of tokens) if (children) rewrite(children, fileOf(page))
  })
}

/** Returns whether a page is generated. Generated pages have no file in the repository, and link only to pages. */
const isGenerated = (page) => page === 'index.md' || /^(commands|examples)\//.test(page)

function rewrite(tokens, file) {
  for (const [i, token] of tokens.entries()) {
    const href = token.type === 'link_open' ? token.attrGet('href') : null
    if (href === null || OUTSIDE.test(href)) continue
    const target = resolveLink(file, decodeURI(href))
    if (target) {
      token.attrSet('href', target.href)
      // VitePress's router handles only pages. With `_self`, the browser loads the target.
      if (target.isExternal) token.attrSet('target', '_self')
    } else {
      toText(token)
      toText(tokens.slice(i).find(({ type }) => type === 'link_close'))
    }
  }
}

function toText(token) {
  Object.assign(token, { type: 'text', tag: '', content: '', nesting: 0 })
}
