/** HTML or SVG text that is already escaped. */
export class Markup {
  readonly text: string

  constructor(text: string) {
    this.text = text
  }
}

/** Value in a template. Text is escaped, lists are joined, and `undefined` is omitted. */
export type Content = Markup | string | number | undefined | readonly Content[]

/** Template tag for HTML. Escapes all values except `Markup`. */
export function html(parts: TemplateStringsArray, ...values: Content[]): Markup {
  return new Markup(String.raw({ raw: parts }, ...values.map(textOf)))
}

/** Escapes text for the content and the quoted attributes of HTML, XML and SVG. */
export function escapeMarkup(text: string): string {
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
  return value === undefined ? '' : escapeMarkup(String(value))
}
