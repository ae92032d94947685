package simrobot.ui.editor;

import java.awt.event.KeyEvent;
import java.util.Locale;
import simrobot.editor.Item;
import simrobot.ui.Glyph;

/** What the mouse does on the floor of the editor. */
public enum EditorTool {
    SELECT(Glyph.POINTER, KeyEvent.VK_V, null),
    WALL(Glyph.WALL, KeyEvent.VK_W, Item.Kind.WALL),
    BOX(Glyph.BOX, KeyEvent.VK_B, Item.Kind.BOX),
    HOME(Glyph.HOME, KeyEvent.VK_H, Item.Kind.HOME),
    TREADMILL(Glyph.TREADMILL, KeyEvent.VK_T, Item.Kind.TREADMILL);

    private final Glyph glyph;
    private final int key;
    private final Item.Kind kind;

    EditorTool(Glyph glyph, int key, Item.Kind kind) {
        this.glyph = glyph;
        this.key = key;
        this.kind = kind;
    }

    Glyph glyph() {
        return glyph;
    }

    /** With Alt it takes up the tool. */
    int key() {
        return key;
    }

    /** What it makes; null for the one that makes nothing. */
    Item.Kind kind() {
        return kind;
    }

    /** As texts and components are called. */
    public String id() {
        return name().toLowerCase(Locale.ROOT);
    }
}
