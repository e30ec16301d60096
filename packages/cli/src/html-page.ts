import { html, type Markup } from './markup.ts'

export interface PageHead {
  title: string
  style: Markup
}

/**
 * Returns a self-contained HTML page that follows the system's dark or light colour scheme.
 *
 * @param body content. Each part ends with a line break.
 * @param script module script, placed after the body.
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
