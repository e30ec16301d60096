import { readFileSync } from 'node:fs'

const helper = readFileSync(new URL('page-helper.js', import.meta.url), 'utf8')

/** Adds our helper to a page, before its own scripts: WebDriver hears of nothing that a page logs. */
export function withHelper(html: string): string {
  return html.replace(/<!doctype html>/i, (start) => `${start}<script>{${helper}}</script>`)
}
