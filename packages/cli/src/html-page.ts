import { html, type Markup } from './markup.ts'

/** What the head of a page holds. */
export interface PageHead {
  title: string
  style: Markup
}

/**
 * The HTML of a page that is one file: dark or light like the reader's system.
 *
 * @param body what is in it; each part ends its line.
 * @param script of a module, run behind the body.
 */
export function htmlPage({ title, style }: PageHead, body: Markup, script?: Markup): string {
  return html`<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="dark light">
<title>${title}</title>
<style>${style}</style>
</head>
<body>
${body}${script && html`<script type="module">${script}</script>\n`}</body>
</html>
`.text
}
