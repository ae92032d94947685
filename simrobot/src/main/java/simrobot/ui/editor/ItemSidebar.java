package simrobot.ui.editor;

import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.awt.event.KeyEvent;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import javax.swing.DefaultListCellRenderer;
import javax.swing.DefaultListModel;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JPanel;
import javax.swing.JTextField;
import javax.swing.KeyStroke;
import javax.swing.ListSelectionModel;
import simgsm.console.TextBundle;
import simgsm.draw.Ink;
import simgsm.ui.Arrange;
import simgsm.ui.Card;
import simgsm.ui.ComponentNames;
import simgsm.ui.Theme;
import simgsm.ui.UserAction;
import simgsm.ui.VerticalScrollPane;
import simrobot.editor.Draft;
import simrobot.editor.Edits;
import simrobot.editor.Item;
import simrobot.editor.ItemFields;
import simrobot.ui.TextLine;
import simrobot.world.World;

/** The fields of the selected item and the list of all items, at the right of the editor's floor. */
final class ItemSidebar extends JPanel {
    private final TextBundle texts;
    private final EditorView floor;
    private final DefaultListModel<Item> model = new DefaultListModel<>();
    private final JList<Item> list = new JList<>(model);
    private final Map<String, JTextField> fields = new LinkedHashMap<>();
    private final JPanel form = Arrange.column(6);
    private final TextLine problem = new TextLine("editor.problem", Theme::small, Ink.DANGER);
    private Item shown;
    private World listed;
    private boolean updating;

    ItemSidebar(TextBundle texts, EditorView floor) {
        super(new BorderLayout());
        this.texts = texts;
        this.floor = floor;
        setOpaque(false);
        ComponentNames.name(list, "editor.items", texts.of("editor.items"));
        list.setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
        list.setCellRenderer(new Renderer());
        new UserAction("editor.items.erase", "", () -> floor.step(floor.draft()::deleteSelected))
                .bind(list, WHEN_FOCUSED, KeyStroke.getKeyStroke(KeyEvent.VK_DELETE, 0));
        list.addListSelectionListener(event -> {
            if (!updating && !event.getValueIsAdjusting() && list.getSelectedValue() != null) {
                floor.draft().select(list.getSelectedValue());
                floor.fireChanged();
            }
        });
        JPanel properties = Arrange.column(6, form, problem);
        add(Arrange.column(
                Theme.GRID,
                new Card(texts.of("editor.properties"), properties),
                Arrange.growing(new Card(texts.of("editor.items"), new VerticalScrollPane(list)))));
    }

    @Override
    public Dimension getPreferredSize() {
        return new Dimension(Theme.px(270), super.getPreferredSize().height);
    }

    void show(Draft draft) {
        updating = true;
        if (draft.world() != listed) {
            listed = draft.world();
            model.clear();
            model.addAll(EditorItems.all(listed));
        }
        Item item = draft.selected().orElse(null);
        if (item == null) {
            list.clearSelection();
        } else if (!item.equals(list.getSelectedValue())) {
            list.setSelectedValue(item, true);
        }
        updating = false;
        showFields(draft, item);
    }

    private void showFields(Draft draft, Item item) {
        Map<String, String> values = item == null ? Map.of() : ItemFields.of(draft.world(), item);
        if (!List.copyOf(values.keySet()).equals(List.copyOf(fields.keySet())) || fields.isEmpty()) {
            build(values);
        }
        boolean other = item == null || !item.equals(shown);
        shown = item;
        values.forEach((key, value) -> {
            JTextField field = fields.get(key);
            if (!field.getText().equals(value) && (other || !field.isFocusOwner())) {
                field.setText(value);
            }
        });
        if (other) {
            problem.show("");
        }
    }

    private void build(Map<String, String> values) {
        fields.clear();
        form.removeAll();
        if (values.isEmpty()) {
            TextLine none = new TextLine("editor.nothing", Theme::small, Ink.QUIET);
            none.show(texts.of("editor.nothing"));
            form.add(none);
        }
        JPanel row = null;
        for (String key : values.keySet()) {
            JTextField field = field(key);
            JLabel label = new JLabel(texts.of("editor.field." + key));
            label.setLabelFor(field);
            JPanel labelled = Arrange.growing(Arrange.column(2, label, field));
            boolean alone = key.equals("name") || key.equals("heading");
            if (row == null || alone || row.getComponentCount() == 2) {
                row = Arrange.row(Theme.GRID, labelled);
                form.add(row);
            } else {
                row.add(labelled);
            }
            row = alone ? null : row;
        }
        form.revalidate();
        form.repaint();
    }

    private JTextField field(String key) {
        JTextField field =
                ComponentNames.name(new JTextField(6), "editor.field." + key, texts.of("editor.field." + key));
        field.addActionListener(event -> applyFields());
        field.addFocusListener(new FocusAdapter() {
            @Override
            public void focusLost(FocusEvent event) {
                applyFields();
            }
        });
        fields.put(key, field);
        return field;
    }

    /** Makes the typed values a step of the draft. */
    private void applyFields() {
        Draft draft = floor.draft();
        if (shown == null || !draft.selected().filter(shown::equals).isPresent()) {
            return;
        }
        Map<String, String> typed = new LinkedHashMap<>();
        fields.forEach((key, field) -> typed.put(key, field.getText()));
        try {
            World next = ItemFields.changed(draft.committed(), shown, typed);
            problem.show("");
            if (next != draft.committed()) {
                draft.change(next);
                shown = null;
                floor.fireChanged();
            }
        } catch (ItemFields.FieldRefusal refusal) {
            problem.show(texts.of(
                    "editor.field.refused", texts.of("editor.field." + refusal.field()), refusal.getMessage()));
        }
    }

    private final class Renderer extends DefaultListCellRenderer {
        @Override
        public Component getListCellRendererComponent(
                JList<?> owner, Object value, int index, boolean selected, boolean focus) {
            String text = EditorItems.text(texts, Edits.get(listed, (Item) value));
            return super.getListCellRendererComponent(owner, text, index, selected, focus);
        }
    }
}
