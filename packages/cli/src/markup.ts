/** Markup that is not escaped again. */
export class Markup {
  readonly text: string

  constructor(text: string) {
    this.text = text
  }
}

/** Value in a template: text is escaped, lists are joined, `undefined` is omitted. */
export type Content = Markup | string | number | undefined | readonly Content[]

/** Template tag for HTML: escapes all values except `Markup`. */
export function html(parts: TemplateStringsArray, ...values: Content[]): Markup {
  return new Markup(String.raw({ raw: parts }, ...values.map(textOf)))
}

/** Escapes text for content and quoted attributes of HTML, XML and SVG. */
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
