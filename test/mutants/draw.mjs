// Draws random mutants of the sources, deterministic per seed:
//     node test/mutants/draw.mjs [SEED] > test/mutants/mutants.json
// A mutant changes one expression or statement, like a programming error. It is located by the text of its line.

import { readdirSync, readFileSync } from 'node:fs'
import { join } from 'node:path'
import { fileURLToPath } from 'node:url'
// The site installs the last TypeScript release that has a compiler API.
import ts from '../../site/node_modules/typescript/lib/typescript.js'

const ROOT = fileURLToPath(new URL('../../', import.meta.url))
const LIBRARY = 'packages/furrow/src'
const FILES = 'packages/files/src'

/** Parts of the sources, with their folders and the number of mutants to draw from each. */
const ROOMS = {
  core: { folders: [`${LIBRARY}/core`], count: 30 },
  math: { folders: [`${LIBRARY}/math`], count: 20 },
  drivers: { folders: [`${LIBRARY}/drivers`], count: 30 },
  runtime: { folders: [`${LIBRARY}/runtime`], count: 25 },
  gltf: { folders: [`${LIBRARY}/gltf`], count: 15 },
  author: { folders: [`${LIBRARY}/author`], count: 45 },
  files: { folders: [FILES], count: 35 },
}

/** Files without mutants: tables of constants, type declarations, and variants for browsers, which no test in Node loads. */
const LEFT_OUT = /(basis-tables|\.d|\.browser)\.ts$/

const FLIPS = {
  '<': '<=',
  '<=': '<',
  '>': '>=',
  '>=': '>',
  '===': '!==',
  '!==': '===',
  '+': '-',
  '-': '+',
  '*': '/',
  '/': '*',
  '%': '*',
  '&&': '||',
  '||': '&&',
}

const CALLS = {
  some: 'every',
  every: 'some',
  min: 'max',
  max: 'min',
  floor: 'ceil',
  ceil: 'floor',
  sin: 'cos',
  cos: 'sin',
  startsWith: 'endsWith',
  find: 'findLast',
  indexOf: 'lastIndexOf',
}

const seed = Number(process.argv[2] ?? 2026)
const random = mulberry32(seed)
const drawn = Object.entries(ROOMS).flatMap(([room, { folders, count }]) => drawRoom(room, folders, count))
const mutants = drawn.map((mutant, i) => ({ id: i + 1, ...mutant }))
process.stdout.write(`${JSON.stringify({ seed, mutants })}\n`)

function drawRoom(room, folders, count) {
  const found = folders
    .flatMap(filesIn)
    .flatMap((file) => mutantsOf(file).map((mutant) => ({ room, ...mutant })))
  // Keeps 40% of the mutants that change a number. Otherwise, they would be a third of all mutants.
  const all = found.filter(({ kind }) => kind !== 'number + 1' || random() < 0.4)
  const taken = []
  while (taken.length < count) {
    const [mutant] = all.splice(Math.floor(random() * all.length), 1)
    // Takes at most one mutant per line, and counts equal lines of a file as one line, because they have equal mutants.
    if (taken.every(({ file, line }) => file !== mutant.file || line !== mutant.line)) taken.push(mutant)
  }
  return taken.sort((a, b) => (a.file < b.file ? -1 : a.file > b.file ? 1 : 0))
}

function filesIn(folder) {
  return readdirSync(join(ROOT, folder), { recursive: true, encoding: 'utf8' })
    .filter((name) => name.endsWith('.ts'))
    .map((name) => `${folder}/${name}`)
    .filter((path) => !LEFT_OUT.test(path))
    .sort()
}

function mutantsOf(file) {
  const text = readFileSync(join(ROOT, file), 'utf8')
  const lines = text.split('\n')
  const source = ts.createSourceFile(file, text, ts.ScriptTarget.Latest, true)
  const found = []
  visit(source)
  return found

  function add(node, becomes, kind) {
    const start = source.getLineAndCharacterOfPosition(node.getStart())
    const end = source.getLineAndCharacterOfPosition(node.getEnd())
    if (start.line !== end.line) return
    const line = lines[start.line]
    const nth = lines.slice(0, start.line).filter((other) => other === line).length
    const indent = line.length - line.trimStart().length
    found.push({
      file,
      line: line.trim(),
      ...(nth > 0 && { nth }),
      at: start.character - indent,
      was: node.getText(),
      becomes,
      kind,
      ...(ts.isExpressionStatement(node.parent) && { isStatement: true }),
    })
  }

  function visit(node) {
    // Skips error messages, types and imports, which are not behaviour.
    if (ts.isThrowStatement(node) || ts.isTypeNode(node) || ts.isImportDeclaration(node)) return
    if (ts.isNewExpression(node) && node.expression.getText() === 'FurrowError') return
    mutate(node)
    ts.forEachChild(node, visit)
  }

  function mutate(node) {
    if (ts.isIfStatement(node) || ts.isWhileStatement(node))
      add(node.expression, `!(${node.expression.getText()})`, 'negated condition')
    if (ts.isConditionalExpression(node))
      add(node.condition, `!(${node.condition.getText()})`, 'negated condition')
    if (ts.isBinaryExpression(node)) mutateBinary(node)
    if (
      ts.isNumericLiteral(node) &&
      !ts.isPropertyAssignment(node.parent?.name === node ? node.parent : source)
    ) {
      add(node, `(${node.getText()} + 1)`, 'number + 1')
    }
    if (node.kind === ts.SyntaxKind.TrueKeyword) add(node, 'false', 'flipped boolean')
    if (node.kind === ts.SyntaxKind.FalseKeyword) add(node, 'true', 'flipped boolean')
    if (ts.isPrefixUnaryExpression(node) && '-!'.includes(ts.tokenToString(node.operator))) {
      add(node, node.operand.getText(), 'removed sign')
    }
    if (ts.isExpressionStatement(node) && !ts.isStringLiteral(node.expression)) {
      const { expression } = node
      const isEffect = ts.isCallExpression(expression)
        ? expression.expression.kind !== ts.SyntaxKind.SuperKeyword
        : isAssignment(expression)
      if (isEffect) add(expression, 'undefined', 'removed statement')
    }
    if (ts.isCallExpression(node) && ts.isPropertyAccessExpression(node.expression)) mutateCall(node)
  }

  function mutateBinary(node) {
    const operator = ts.tokenToString(node.operatorToken.kind)
    const [left, right] = [node.left.getText(), node.right.getText()]
    const isText = [node.left, node.right].some(
      (side) => ts.isStringLiteralLike(side) || ts.isTemplateExpression(side),
    )
    if (operator in FLIPS && !(isText && operator === '+')) {
      add(node, `${left} ${FLIPS[operator]} ${right}`, `${operator} as ${FLIPS[operator]}`)
    }
    if (operator === '**') add(node, `${left} * ${right}`, '** as *')
    if (operator === '??') add(node, `(${right})`, 'default always')
  }

  function mutateCall(node) {
    const { expression, arguments: words } = node
    const name = expression.name.text
    const [receiver, list] = [expression.expression.getText(), words.map((word) => word.getText()).join(', ')]
    if (name in CALLS) add(node, `${receiver}.${CALLS[name]}(${list})`, `${name} as ${CALLS[name]}`)
    if (['filter', 'sort', 'toSorted', 'reverse', 'toReversed', 'slice', 'trim'].includes(name))
      add(node, receiver, `no ${name}`)
  }
}

function isAssignment(node) {
  if (ts.isPostfixUnaryExpression(node) || ts.isPrefixUnaryExpression(node)) return true
  return ts.isBinaryExpression(node) && /^[-+*/%&|^?]*=$/.test(node.operatorToken.getText())
}

function mulberry32(state) {
  return () => {
    state = (state + 0x6d2b79f5) | 0
    let t = Math.imul(state ^ (state >>> 15), state | 1)
    t ^= t + Math.imul(t ^ (t >>> 7), t | 61)
    return ((t ^ (t >>> 14)) >>> 0) / 2 ** 32
  }
}
