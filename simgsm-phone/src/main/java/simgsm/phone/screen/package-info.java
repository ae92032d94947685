/**
 * What the display shows and what each key does: pages on a stack, above them the home screen. Menus are data: rows with
 * what is done when they are chosen. Texts are keys of the bundle, so the pages know no language; a test drives them by key
 * strokes.
 *
 * <pre>
 *   key --> HomeKeys or the page on top of PageStack --> KeyIntent, which the handset performs
 *                                                    --> Screen and SoftKeys, which the display draws
 * </pre>
 *
 * <p>Read first: {@link simgsm.phone.screen.Screen}, then {@code ScreenPage}, {@code ListPage} and {@code MainMenu}.
 */
package simgsm.phone.screen;
