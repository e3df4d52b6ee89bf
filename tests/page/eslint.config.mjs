export default [
  {
    files: ['**/*.js', '**/*.mjs'],
    languageOptions: { ecmaVersion: 2024, sourceType: 'module' },
    rules: {
      'no-unused-vars': ['error', { ignoreRestSiblings: true }],
      'no-undef': 'off', // tsc checks it
      'prefer-const': 'error',
      eqeqeq: 'error',
      'no-var': 'error',
      'no-implied-eval': 'error',
      'no-eval': 'error',
      'no-self-compare': 'error',
      'no-unreachable': 'error',
      complexity: ['error', 14],
      'max-lines': ['error', 320],
      'max-depth': ['error', 3],
    },
  },
];
