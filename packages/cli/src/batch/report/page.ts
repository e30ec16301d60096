import { htmlPage } from '../../html-page.ts'
import { html, type Markup } from '../../markup.ts'
import type { ResultLine } from '../results.ts'
import { PAGE_SCRIPT, PAGE_STYLE } from './page-style.ts'
import { type Cell, foundText, MAX_ROWS, rowsOf, sizeCell, timeCell } from './rows.ts'
import { THUMBNAIL } from './thumbnails.ts'

export interface PageSource {
  command: string
  lines: readonly ResultLine[]
  /** Counts of all results as text, one line. */
  summary: string
  /** File name of the results, beside the page. */
  results: string
  /** Returns the URLs of the thumbnails of a result, relative to the page. Returns undefined if there are none. */
  thumbnails: (line: ResultLine) => readonly [before: string, after: string] | undefined
  /** Returns the URL of an output, relative to the page. */
  linkTo: (output: string) => string
  /** Remarks for the top of the page, e.g. why thumbnails are missing. */
  notes: readonly string[]
}

const COLUMNS = ['File', 'State', 'Found', 'Size', 'Time'] as const

/** Position of `COLUMNS[0]` among the columns of the table. The thumbnails are in column 0. */
const FIRST = 1

/** Returns the HTML report of a batch. Thumbnails are separate files. */
export function batchPage(source: PageSource): string {
  const rows = rowsOf(source.lines)
  const isTruncated = source.lines.length > MAX_ROWS
  const body = html`<header>
<h1>furrow batch, ${source.command}</h1>
<p><b>${source.summary}</b></p>
${isTruncated ? html`<p>This page shows ${MAX_ROWS} files, failures and warnings first. All results: <a href="${source.results}">${source.results}</a>.</p>` : undefined}
${source.notes.map((note) => html`<p>${note}</p>`)}
</header>
<main>
<div class="tools" hidden>
<label>Show <select id="show"><option value="">all</option><option value="failed">failed</option>
<option value="warned">with warnings</option><option value="done">without problems</option></select></label>
<label class="sort">Order <select id="order"><option value="">failures first</option>
${COLUMNS.map((name, i) => html`<option value="${FIRST + i} up">${name}, up</option><option value="${FIRST + i} down">${name}, down</option>`)}</select></label>
<span id="shown" role="status">${rows.length} shown</span>
</div>
<table>
<thead><tr><th scope="col">Before and after</th>
${COLUMNS.map((name, i) => html`<th scope="col" data-column="${FIRST + i}"><button type="button">${name}</button></th>`)}
<th scope="col">Notes</th></tr></thead>
<tbody>${rows.map((line) => rowOf(line, source))}</tbody>
</table>
</main>
`
  return htmlPage({ title: `furrow batch: ${source.summary}`, style: PAGE_STYLE }, body, PAGE_SCRIPT)
}

function rowOf(line: ResultLine, { thumbnails, linkTo }: PageSource): Markup {
  const { status, input, output, warnings, reason, sameAs } = line
  const state = status === 'failed' ? 'failed' : warnings.length > 0 ? 'warned' : 'done'
  const pictures = thumbnails(line)
  const isMade = status === 'done' && output !== undefined
  return html`<tr class="${state}">
<td class="face">${pictures && pair(pictures, input)}</td>
<th scope="row" data-value="${input}">${isMade ? html`<a href="${linkTo(output)}">${input}</a>` : input}</th>
<td class="state" data-value="${state}">${state}</td>
<td data-value="${foundText(line)}">${foundText(line)}</td>
${cell('Size', sizeCell(line))}
${cell('Time', timeCell(line))}
<td class="notes">${reason}${warnings.length > 0 ? html`<ul>${warnings.map((text) => html`<li>${text}</li>`)}</ul>` : undefined}${sameAs === undefined ? undefined : html`<small>identical to ${sameAs}</small>`}</td>
</tr>`
}

function pair([before, after]: readonly [string, string], name: string): Markup {
  const image = (file: string, how: string) =>
    html`<img src="${file}" width="${THUMBNAIL.width}" height="${THUMBNAIL.height}" loading="lazy" alt="${name}, ${how} wrinkles">`
  return html`<a class="pair" href="${after}">${image(before, 'without')}${image(after, 'with')}</a>`
}

function cell(label: string, { text, value }: Cell): Markup {
  return html`<td data-label="${label}" data-value="${value}">${text}</td>`
}
