/**
 * The world editor's window. Read {@link simrobot.ui.editor.EditorPanel}.
 */
package simrobot.ui.editor;
