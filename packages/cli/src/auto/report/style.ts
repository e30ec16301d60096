import { Markup } from '../../markup.ts'

/** Style sheet of the report of `furrow auto`. Follows the system's colour scheme. Phones show one column. */
export const STYLE = new Markup(`
:root {
  --paper: #ffffff; --card: #f4f4f2; --ink: #1d1e20; --soft: #5c5f66; --line: #dcdcd8;
  --more: #b3402f; --less: #2c6aa0; --warn: #fff4d6; --warn-ink: #5b4300;
}
@media (prefers-color-scheme: dark) {
  :root {
    --paper: #151618; --card: #1e2023; --ink: #ececea; --soft: #a2a5ab; --line: #33363b;
    --more: #ff8f7a; --less: #7fbdf0; --warn: #3a3013; --warn-ink: #ffe3a0;
  }
}
* { box-sizing: border-box; }
body { margin: 0 auto; max-width: 1240px; padding: 32px 24px 64px; background: var(--paper); color: var(--ink);
  font: 16px/1.5 system-ui, sans-serif; overflow-wrap: anywhere; }
h1 { margin: 0 0 4px; font-size: 28px; line-height: 1.2; }
h2 { margin: 48px 0 4px; font-size: 21px; line-height: 1.3; }
h3 { margin: 0 0 8px; font-size: 15px; }
p { margin: 0 0 16px; max-width: 75ch; color: var(--soft); }
header b, p b { color: var(--ink); }
img { display: block; width: 100%; height: auto; border-radius: 6px; }
a:focus-visible { outline: 3px solid var(--less); outline-offset: 2px; }
figure { margin: 0; }
figcaption { padding-top: 8px; font-size: 14px; }
.warnings { margin: 16px 0 0; padding: 12px 16px 12px 34px; border-radius: 8px; background: var(--warn); color: var(--warn-ink); }
.missing { padding: 14px 16px; border: 1px solid var(--line); border-radius: 8px; }
.pairs { display: grid; grid-template-columns: repeat(2, minmax(0, 1fr)); gap: 28px 24px; }
.pair { display: grid; grid-template-columns: 1fr 1fr; gap: 2px; }
.pair.three { grid-template-columns: 1fr 1fr 1fr; }
.pair.three a:nth-child(2) img { border-radius: 0; }
.pair a:first-child img { border-radius: 6px 0 0 6px; }
.pair a:last-child img { border-radius: 0 6px 6px 0; }
.chips { display: flex; flex-wrap: wrap; gap: 2px 12px; font-size: 13px; color: var(--soft); }
.chip b { font-weight: 600; font-variant-numeric: tabular-nums; }
.chip.more b { color: var(--more); }
.chip.less b { color: var(--less); }
.legend { max-width: 420px; margin: 0 0 16px; }
.legend div { height: 14px; border-radius: 4px; border: 1px solid var(--line); }
.legend p { display: flex; justify-content: space-between; margin: 4px 0 0; font-size: 13px; }
.tiles { display: grid; grid-template-columns: repeat(4, minmax(0, 1fr)); gap: 20px; }
.tiles img { background: var(--card); }
table { width: 100%; border-collapse: collapse; font-size: 15px; }
th, td { padding: 8px 12px 8px 0; border-top: 1px solid var(--line); text-align: left; vertical-align: middle; }
thead th, thead td { border: 0; font-size: 13px; font-weight: 500; color: var(--soft); overflow-wrap: normal; }
td { font-variant-numeric: tabular-nums; }
td.map { width: 112px; }
td.links { width: 46%; padding-right: 0; }
.facts { display: grid; grid-template-columns: repeat(4, minmax(0, 1fr)); gap: 16px; margin-top: 12px; align-items: start; }
.facts > div { padding: 16px; border-radius: 8px; background: var(--card); }
dl { margin: 0; font-size: 14px; }
dl div { display: flex; justify-content: space-between; gap: 16px; padding: 3px 0; }
dt { color: var(--soft); flex: none; }
dd { margin: 0; text-align: right; font-variant-numeric: tabular-nums; }
@media (max-width: 1000px) {
  .tiles, .facts { grid-template-columns: repeat(2, minmax(0, 1fr)); }
}
@media (max-width: 720px) {
  body { padding: 20px 16px 48px; }
  h1 { font-size: 24px; }
  h2 { margin-top: 36px; }
  .pairs, .facts { grid-template-columns: minmax(0, 1fr); gap: 24px; }
  .facts { gap: 12px; }
  .tiles { gap: 12px; }
  thead { display: none; }
  table, tbody { display: block; }
  tr { display: grid; grid-template-columns: 96px 7fr 5fr; gap: 2px 14px; align-items: start;
    padding: 14px 0; border-top: 1px solid var(--line); }
  th, td { display: block; padding: 0; border: 0; font-size: 14px; }
  tr td.map { grid-row: 1 / 4; width: 96px; }
  tr th { grid-column: 2 / 4; font-size: 16px; }
  td[data-label]::before { content: attr(data-label) ' '; color: var(--soft); }
  tr td.links { grid-column: 1 / 4; width: auto; padding-top: 6px; }
}
`)
