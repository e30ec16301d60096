import { templateCompilerOptions } from '@tresjs/core'
import vue from '@vitejs/plugin-vue'

export default { plugins: [vue({ ...templateCompilerOptions })] }
