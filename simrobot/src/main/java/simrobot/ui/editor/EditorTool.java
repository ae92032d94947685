package simrobot.ui.editor;

import java.awt.event.KeyEvent;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import simgsm.ui.Symbol;
import simrobot.world.ItemKind;
import simrobot.world.ItemKinds;

/**
 * A tool of the editor.
 *
 * @param kind drawn by it; null for the selection tool
 */
public record EditorTool(ItemKind<?> kind) {
    static final EditorTool SELECT = new EditorTool(null);

    /** The selection tool, then one for each kind that can be drawn. */
    public static final List<EditorTool> ALL = Stream.concat(
                    Stream.of(SELECT), ItemKinds.edited().map(EditorTool::new))
            .toList();

    /** True if it draws a kind of this shape. */
    boolean draws(ItemKind.Shape shape) {
        return kind != null && kind.shape() == shape;
    }

    /** The symbol with the kind's name; a box if there is none. */
    Symbol symbol() {
        return kind == null
                ? Symbol.POINTER
                : Arrays.stream(Symbol.values())
                        .filter(symbol -> symbol.name().equals(id().toUpperCase(Locale.ROOT)))
                        .findFirst()
                        .orElse(Symbol.BOX);
    }

    /** The key that, with Alt, selects the tool: V, or the first letter of the kind's English word. */
    int key() {
        return kind == null ? KeyEvent.VK_V : KeyEvent.getExtendedKeyCodeForChar(id().charAt(0));
    }

    /** Part of the keys of its texts and of its component's name. */
    public String id() {
        return kind == null ? "select" : kind.word();
    }
}
