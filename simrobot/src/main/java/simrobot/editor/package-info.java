/**
 * Editing a world, without a window: {@link simrobot.editor.Draft} holds the world with its history and what is selected;
 * {@link simrobot.editor.Edits} makes one world of another. Read {@code Draft} first. Metres and radians.
 */
package simrobot.editor;
