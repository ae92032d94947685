/**
 * The content of the display and the function of each key: pages on a stack above the home screen. Menus are data:
 * rows with their actions. Texts are keys of the bundle, so pages are independent of the language; tests drive them
 * by key strokes.
 * <pre>
 *   key --> HomeKeys or the page on top of PageStack --> KeyIntent, which the handset performs
 *                                                    --> Screen and SoftKeys, which the display draws
 * </pre>
 *
 * <p>Read first: {@link simgsm.phone.screen.Screen}, then {@code ScreenPage}, {@code ListPage} and {@code MainMenu}.
 */
package simgsm.phone.screen;
