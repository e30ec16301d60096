/** Text that is markup already. */
export class Markup {
  readonly text: string

  constructor(text: string) {
    this.text = text
  }
}

/** What can stand in markup: text is escaped, lists are joined, and what is missing is nothing. */
export type Content = Markup | string | number | undefined | readonly Content[]

/** HTML from a template; whatever is put in is escaped unless it is markup itself. */
export function html(parts: TemplateStringsArray, ...values: Content[]): Markup {
  return new Markup(String.raw({ raw: parts }, ...values.map(textOf)))
}

/** A text as it stands between tags and in quoted attributes of HTML, XML and SVG. */
export function escaped(text: string): string {
  return text
    .replaceAll('&', '&amp;')
    .replaceAll('<', '&lt;')
    .replaceAll('>', '&gt;')
    .replaceAll('"', '&quot;')
    .replaceAll("'", '&#39;')
    .replace(/\p{Cc}/gu, ' ')
}

function textOf(value: Content): string {
  if (value instanceof Markup) return value.text
  if (Array.isArray(value)) return value.map(textOf).join('')
  return value === undefined ? '' : escaped(String(value))
}
