package simgsm.phone.screen;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import simgsm.dtmf.DtmfKey;
import simgsm.phone.screen.KeyIntent.Simple;

/**
 * A page of rows to choose from. Each reading of the list builds its rows, so they are up to date; the selected row
 * stays selected when rows are inserted before it.
 */
final class ListPage extends ScreenPage {
    /**
     * A row and its actions.
     *
     * @param key identifies the row while the list changes
     * @param called by the green key; empty if the row is no party
     * @param options by the left key; empty if there are none
     */
    record ListItem(
            Object key,
            Screen.Row row,
            Supplier<KeyIntent> chosen,
            Optional<Supplier<KeyIntent>> called,
            Optional<Supplier<KeyIntent>> options) {
        /** A row with only the action of choosing. */
        static ListItem of(Screen.Row row, Supplier<KeyIntent> chosen) {
            return new ListItem(row.label(), row, chosen, Optional.empty(), Optional.empty());
        }

        /** A row of a menu. @param text key of the bundle */
        static ListItem of(String text, Supplier<KeyIntent> chosen) {
            return of(Screen.Row.of(Words.of(text)), chosen);
        }
    }

    private final Words title;
    private final Supplier<List<ListItem>> source;
    private final boolean numbered;
    private int selected;
    private Object selectedKey;

    /** @param numbered true if the digit keys choose rows, as in a menu; the green key then does so, too */
    ListPage(PageStack stack, Words title, boolean numbered, Supplier<List<ListItem>> source) {
        super(stack);
        this.title = title;
        this.source = source;
        this.numbered = numbered;
    }

    /** A menu. */
    static ListPage menu(PageStack stack, String title, Supplier<List<ListItem>> source) {
        return new ListPage(stack, Words.of(title), true, source);
    }

    /** Selects a row. */
    ListPage selecting(int index) {
        move(items(), index);
        return this;
    }

    /** A menu without rows, for {@link #option}. */
    static ListPage options(PageStack stack, Words title) {
        List<ListItem> items = new ArrayList<>();
        return new ListPage(stack, title, true, () -> items);
    }

    /** Adds a row if it is offered; it closes this page before its action. */
    ListPage option(boolean isOffered, String text, Supplier<KeyIntent> act) {
        if (isOffered) {
            source.get().add(ListItem.of(text, () -> {
                stack.close(this);
                return act.get();
            }));
        }
        return this;
    }

    private List<ListItem> items() {
        List<ListItem> items = source.get();
        if (selected > 0) {
            for (int i = 0; i < items.size(); i++) {
                if (items.get(i).key().equals(selectedKey)) {
                    selected = i;
                    return items;
                }
            }
        }
        move(items, Math.max(0, Math.min(selected, items.size() - 1)));
        return items;
    }

    private void move(List<ListItem> items, int index) {
        selected = index;
        selectedKey = items.isEmpty() ? null : items.get(index).key();
    }

    @Override
    Screen screen() {
        return new Screen.Listing(title, items().stream().map(ListItem::row).toList(), selected, numbered);
    }

    @Override
    SoftKeys softKeys() {
        List<ListItem> items = items();
        if (items.isEmpty()) {
            return SoftKeys.BACK;
        }
        return items.get(selected).options().isPresent() ? new SoftKeys("soft.options", "soft.back") : SoftKeys.SELECT;
    }

    @Override
    KeyIntent press(PhoneKey key, long nowNanos) {
        List<ListItem> items = items();
        return switch (key) {
            case SOFT_RIGHT, LEFT, CLEAR, MENU -> stack.close(this);
            case UP, DOWN -> {
                if (!items.isEmpty()) {
                    move(items, (selected + (key == PhoneKey.UP ? items.size() - 1 : 1)) % items.size());
                }
                yield Simple.NOTHING;
            }
            default -> items.isEmpty() ? Simple.NOTHING : choose(items, key);
        };
    }

    private KeyIntent choose(List<ListItem> items, PhoneKey key) {
        ListItem item = items.get(selected);
        return switch (key) {
            case OK, RIGHT -> item.chosen().get();
            case SOFT_LEFT -> item.options().orElse(item.chosen()).get();
            case CALL ->
                numbered
                        ? item.chosen().get()
                        : item.called().map(Supplier::get).orElse(Simple.NOTHING);
            default -> numbered ? numbered(items, key) : Simple.NOTHING;
        };
    }

    private KeyIntent numbered(List<ListItem> items, PhoneKey key) {
        int index = key.tone().map(DtmfKey::symbol).orElse('0') - '1';
        if (index < 0 || index >= items.size()) {
            return Simple.NOTHING;
        }
        move(items, index);
        return items.get(index).chosen().get();
    }
}
