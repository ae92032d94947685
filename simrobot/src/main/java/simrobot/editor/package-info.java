/**
 * The world editor without its window. Read first {@link simrobot.editor.Draft}, the world with its history and its
 * selected item; {@link simrobot.editor.Edits} changes worlds. Metres and radians.
 */
package simrobot.editor;
