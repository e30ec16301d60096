import { Markup } from '../../markup.ts'

/** Style sheet of the batch report. Follows the system's colour scheme. Phones show each row of the table as a card. */
export const PAGE_STYLE = new Markup(`
:root {
  --paper: #ffffff; --card: #f4f4f2; --ink: #1d1e20; --soft: #5c5f66; --line: #dcdcd8;
  --bad: #a8321f; --warn: #7a5a00; --link: #1f5f99;
}
@media (prefers-color-scheme: dark) {
  :root {
    --paper: #151618; --card: #1e2023; --ink: #ececea; --soft: #a2a5ab; --line: #33363b;
    --bad: #ff8f7a; --warn: #ffd479; --link: #8cc4f2;
  }
}
* { box-sizing: border-box; }
body { margin: 0 auto; max-width: 1240px; padding: 32px 24px 64px; background: var(--paper); color: var(--ink);
  font: 16px/1.5 system-ui, sans-serif; }
h1, p, li, .notes, tbody th { overflow-wrap: anywhere; }
h1 { margin: 0 0 4px; font-size: 28px; line-height: 1.2; }
p { margin: 0 0 12px; max-width: 75ch; color: var(--soft); }
p b { color: var(--ink); }
a { color: var(--link); }
:focus-visible { outline: 3px solid var(--link); outline-offset: 2px; }
.tools { display: flex; flex-wrap: wrap; gap: 8px 16px; align-items: center; margin: 20px 0; }
select, button { font: inherit; color: inherit; background: var(--card); border: 1px solid var(--line); border-radius: 6px;
  padding: 6px 10px; min-height: 40px; }
th button { padding: 6px 0; border: 0; background: none; font: inherit; color: inherit; cursor: pointer; text-align: left; }
th[aria-sort=ascending] button::after { content: ' \\2191'; }
th[aria-sort=descending] button::after { content: ' \\2193'; }
table { width: 100%; border-collapse: collapse; font-size: 15px; }
th, td { padding: 8px 14px 8px 0; border-top: 1px solid var(--line); text-align: left; vertical-align: top;
  font-variant-numeric: tabular-nums; }
thead th { border: 0; vertical-align: middle; font-size: 14px; font-weight: 500; color: var(--soft); white-space: nowrap; }
tbody th { min-width: 150px; }
td[data-label] { white-space: nowrap; }
.pair { display: grid; grid-template-columns: 96px 96px; gap: 2px; }
img { display: block; width: 96px; height: 128px; border-radius: 4px; background: var(--card); }
tr.failed .state { color: var(--bad); font-weight: 600; }
tr.warned .state { color: var(--warn); font-weight: 600; }
td small { display: block; color: var(--soft); font-size: 13px; }
td ul { margin: 0; padding-left: 18px; font-size: 14px; }
@media (max-width: 760px) {
  body { padding: 20px 16px 48px; }
  h1 { font-size: 24px; }
  thead { display: none; }
  table, tbody { display: block; }
  tbody tr { display: grid; grid-template-columns: 1fr 1fr; gap: 4px 16px; padding: 14px 0; border-top: 1px solid var(--line); }
  tbody th, td { display: block; padding: 0; border: 0; font-size: 15px; }
  tbody th, td.notes, td.face { grid-column: 1 / 3; width: auto; }
  .pair { grid-template-columns: minmax(0, 140px) minmax(0, 140px); }
  img { width: 100%; height: auto; aspect-ratio: 3 / 4; }
  td:empty { display: none; }
  td[data-label]::before { content: attr(data-label) ' '; color: var(--soft); }
}
@media (min-width: 761px) { .sort { display: none; } }
`)

/** Script that sorts and filters the rows of the table. It compares numbers in text by value, e.g. file 2 is before file 10. */
export const PAGE_SCRIPT = new Markup(`
const body = document.querySelector('tbody')
const rows = [...body.rows]
const { compare } = new Intl.Collator('en', { numeric: true })
const heads = [...document.querySelectorAll('th[data-column]')]
const order = document.querySelector('#order')
const show = document.querySelector('#show')
const counter = document.querySelector('#shown')
// Sizes and times have fractions, which Intl.Collator does not compare.
const difference = (x, y) => (isNaN(x) || isNaN(y) ? compare(x, y) : x - y)
function sort(column, down) {
  const sorted = [...rows]
  const valueOf = (row) => row.cells[column].dataset.value
  if (column) sorted.sort((a, b) => (down ? -1 : 1) * difference(valueOf(a), valueOf(b)))
  body.append(...sorted)
  order.value = column ? column + (down ? ' down' : ' up') : ''
  for (const head of heads) {
    if (Number(head.dataset.column) === column) head.setAttribute('aria-sort', down ? 'descending' : 'ascending')
    else head.removeAttribute('aria-sort')
  }
}
for (const head of heads) {
  head.querySelector('button').addEventListener('click', () => {
    sort(Number(head.dataset.column), head.getAttribute('aria-sort') === 'ascending')
  })
}
order.addEventListener('change', () => {
  const [column, direction] = order.value.split(' ')
  sort(Number(column), direction === 'down')
})
show.addEventListener('change', () => {
  for (const row of rows) row.hidden = show.value !== '' && !row.classList.contains(show.value)
  counter.textContent = rows.filter((row) => !row.hidden).length + ' shown'
})
document.querySelector('.tools').hidden = false
`)
