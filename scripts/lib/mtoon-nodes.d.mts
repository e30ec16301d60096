import type { Plugin } from 'vite'

export function mtoonNodes(): Plugin
