package simrobot.ui.editor;

import java.awt.event.KeyEvent;
import java.util.Locale;
import simgsm.ui.Symbol;
import simrobot.editor.Item;

/** The tools of the editor. */
public enum EditorTool {
    SELECT(Symbol.POINTER, KeyEvent.VK_V, null),
    WALL(Symbol.WALL, KeyEvent.VK_W, Item.Kind.WALL),
    BOX(Symbol.BOX, KeyEvent.VK_B, Item.Kind.BOX),
    HOME(Symbol.HOME, KeyEvent.VK_H, Item.Kind.HOME),
    TREADMILL(Symbol.TREADMILL, KeyEvent.VK_T, Item.Kind.TREADMILL);

    private final Symbol symbol;
    private final int key;
    private final Item.Kind kind;

    EditorTool(Symbol symbol, int key, Item.Kind kind) {
        this.symbol = symbol;
        this.key = key;
        this.kind = kind;
    }

    Symbol symbol() {
        return symbol;
    }

    /** The key that, with Alt, selects the tool. */
    int key() {
        return key;
    }

    /** What it makes; null for SELECT. */
    Item.Kind kind() {
        return kind;
    }

    /** Part of the keys of its texts and of its component's name. */
    public String id() {
        return name().toLowerCase(Locale.ROOT);
    }
}
