import { execFileSync } from 'node:child_process'
import MarkdownIt from 'markdown-it'
import { parseSync } from 'vite'
import { ROOT } from './run.mjs'

const CHECKED = /\.(ts|tsx|mjs|js|py|md)$/

/** Files that are not checked: licences, generated data, and a page that will be rewritten. */
const SKIPPED = /THIRD_PARTY_NOTICES\.md$|templates\/template-data\.ts$|^docs\/studio\.md$/

const MAX_WORDS = 30

const NO_SUBJECT = /^(Of|What|That|Those|In which|For which)\s/

/** Comment markers of a line, and the text after them. */
const MARKS = /^\s*(\/\*\*?|\*\/|\*|\/\/|#)?\s?(.*?)\s*(\*\/)?$/

/** Lines that are not prose: horizontal rules, directives to tools, tables. */
const NOT_PROSE = /^(\s*[-=|]{3,}|biome-ignore|@ts-|@vitest|eslint-|region|endregion|!|type:|noqa)/

const markdown = new MarkdownIt({ html: true })
const sentences = new Intl.Segmenter('en', { granularity: 'sentence' })

/** Returns the tracked files whose prose is checked. `paths` limits the list. */
export function checkedFiles(paths = []) {
  const listed = execFileSync('git', ['ls-files', ...paths], { cwd: ROOT, encoding: 'utf8' })
  return listed.split('\n').filter((path) => CHECKED.test(path) && !SKIPPED.test(path))
}

/**
 * Finds sentences that are too long, and comments that begin with a preposition or pronoun instead of a noun or verb.
 *
 * @param {string} path file name. Its extension selects the language.
 * @param {string} text
 * @returns {{ line: number, problem: string, sentence: string }[]} `line` starts at 1.
 */
export function findProblems(path, text) {
  const isPage = path.endsWith('.md')
  return paragraphsOf(path, text).flatMap(({ line, prose }) => {
    const found = []
    if (!isPage && NO_SUBJECT.test(prose))
      found.push({ line, problem: 'begins without a subject', sentence: prose })
    for (const { segment } of sentences.segment(prose)) {
      const words = countWords(segment)
      if (words > MAX_WORDS)
        found.push({ line, problem: `${words} words, at most ${MAX_WORDS}`, sentence: segment.trim() })
    }
    return found
  })
}

/** Counts the words in the comments of a file, or on a Markdown page. */
export function countProse(path, text) {
  return paragraphsOf(path, text).reduce((sum, { prose }) => sum + countWords(prose), 0)
}

function paragraphsOf(path, text) {
  if (path.endsWith('.md')) return paragraphsOfPage(text)
  return path.endsWith('.py') ? commentsOfPython(text) : commentsOfScript(path, text)
}

/** Returns the paragraphs, list items, headings and table cells of a Markdown page. */
function paragraphsOfPage(text) {
  const tokens = markdown.parse(
    text.replace(/^---\n.*?\n---\n/s, (front) => front.replace(/[^\n]/g, '')),
    {},
  )
  return tokens.flatMap((token, i) => {
    if (token.type !== 'inline') return []
    const line = (token.map ?? tokens[i - 1].map ?? [0])[0] + 1
    return [{ line, prose: token.children.map(textOf).join('') }]
  })
}

function textOf({ type, content }) {
  if (type === 'code_inline') return 'Code'
  return type.endsWith('break') ? ' ' : type === 'text' ? content : ''
}

function commentsOfScript(path, text) {
  const { comments } = parseSync(path, text)
  return blocksOf(text, comments)
}

/** Returns the comments and docstrings of a Python file. */
function commentsOfPython(text) {
  const found = text.matchAll(/("""|''')(.*?)\1|"(?:[^"\\\n]|\\.)*"|'(?:[^'\\\n]|\\.)*'|#[^\n]*/gs)
  const comments = [...found].filter(([all, quotes]) => quotes || all.startsWith('#'))
  return blocksOf(
    text,
    comments.map(({ 0: all, index }) => ({ start: index, end: index + all.length })),
  )
}

/** Joins comments on adjacent lines, and then splits them into paragraphs. */
function blocksOf(text, comments) {
  const blocks = []
  let end = -1
  for (const comment of comments) {
    const between = text.slice(Math.max(end, 0), comment.start)
    const isTrailing = text.slice(text.lastIndexOf('\n', comment.start - 1) + 1, comment.start).trim() !== ''
    const line = text.slice(0, comment.start).split('\n').length
    const lines = text
      .slice(comment.start, comment.end)
      .replace(/^("""|''')|("""|''')$/g, '')
      .split('\n')
    if (end >= 0 && !isTrailing && /^\n[^\S\n]*$/.test(between)) blocks.at(-1).lines.push(...lines)
    else blocks.push({ line, lines })
    end = comment.end
  }
  return blocks.flatMap(paragraphsOfComment)
}

/** Splits a comment at empty lines, list items and tags such as `@param`. */
function paragraphsOfComment({ line, lines }) {
  const paragraphs = []
  let isCode = false
  let open
  for (const [i, raw] of lines.entries()) {
    const content = MARKS.exec(raw)[2]
    if (content.startsWith('```')) isCode = !isCode
    const isBreak = isCode || content === '' || content.startsWith('```') || NOT_PROSE.test(content)
    if (isBreak) open = undefined
    else if (open && !/^(@\w|[-*] |\d+\. |:\w+)/.test(content)) open.prose += ` ${content}`
    else {
      open = { line: line + i, prose: content }
      paragraphs.push(open)
    }
  }
  return paragraphs.map(({ line, prose }) => ({ line, prose: withoutCode(prose) }))
}

/** Replaces each piece of code and each web address with one word. Removes tags. */
function withoutCode(prose) {
  return prose
    .replace(/^@\w+\s+(\{.*?\}\s+)?(\[?[\w.]+(=[^\]]*)?\]?\s+(-\s+)?)?/, '')
    .replace(/^[-*] |^\d+\. /, '')
    .replace(/`[^`]*`/g, 'Code')
    .replace(/\{@\w+ ([^}]*)\}/g, '$1')
    .replace(/https?:\S+/g, 'address')
}

function countWords(sentence) {
  return sentence.split(/\s+/).filter((word) => /[\p{L}\p{N}]/u.test(word)).length
}
