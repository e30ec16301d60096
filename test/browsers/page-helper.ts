import { readFileSync } from 'node:fs'

const helper = readFileSync(new URL('page-helper.js', import.meta.url), 'utf8')

/** Inserts page-helper.js before the scripts of a page. It also records console messages, which WebDriver does not report. */
export function withHelper(html: string): string {
  return html.replace(/<!doctype html>/i, (start) => `${start}<script>{${helper}}</script>`)
}
