/** The world editor's panel. Read first {@link simrobot.ui.editor.EditorPanel}. */
package simrobot.ui.editor;
