import { readFileSync } from 'node:fs'

const helper = readFileSync(new URL('page-helper.js', import.meta.url), 'utf8')

/** Adds the helper to a page before its scripts, because WebDriver does not report console messages. */
export function withHelper(html: string): string {
  return html.replace(/<!doctype html>/i, (start) => `${start}<script>{${helper}}</script>`)
}
