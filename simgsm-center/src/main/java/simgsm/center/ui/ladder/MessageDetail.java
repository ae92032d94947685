package simgsm.center.ui.ladder;

import java.awt.BorderLayout;
import java.awt.Container;
import java.awt.Dimension;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.BitSet;
import java.util.Locale;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import simgsm.console.TextBundle;
import simgsm.trace.MessageText;
import simgsm.ui.Arrange;
import simgsm.ui.ComponentNames;
import simgsm.ui.DressedPanel;
import simgsm.ui.Theme;
import simgsm.ui.VerticalScrollPane;
import simgsm.ui.glossary.GlossaryNote;
import simgsm.ui.pane.ScrolledColumn;

/**
 * A message in full: its fields, and its octets at their right or, in a narrow place, below. Selecting a field marks
 * its octets, and an octet its field.
 */
public final class MessageDetail extends DressedPanel {
    private static final int LEAST_FIELDS_UNITS = 200;
    private static final int OCTETS_PER_LINE = 16;
    private static final int LEAST_OCTETS_PER_LINE = 8;
    private static final double LOWER_SHARE = 0.4;

    private final TextBundle texts;
    private final JLabel title = new JLabel(" ");
    private final FieldTable fields = new FieldTable();
    private final HexDump octets;
    private final JScrollPane fieldPane = new JScrollPane(fields);
    private final JScrollPane octetPane;
    private final GlossaryNote note;
    private final Locale language;
    private MessageText shown;
    /** True while a selection in one part is shown in the other. */
    private boolean isFollowing;

    MessageDetail(TextBundle texts) {
        this.texts = texts;
        setOpaque(false);
        setName("ladder.message");
        language = Locale.forLanguageTag(texts.of("window.language"));
        note = new GlossaryNote(language);
        octets = new HexDump(texts, this::octetChosen);
        octetPane = new VerticalScrollPane(new ScrolledColumn(octets));
        fields.getAccessibleContext().setAccessibleName(texts.of("window.ladder.detail"));
        fields.getSelectionModel().addListSelectionListener(event -> fieldChosen());
        JPanel parts = new JPanel(new Parts());
        parts.setOpaque(false);
        parts.add(fieldPane);
        parts.add(octetPane);
        add(ComponentNames.name(title, "ladder.title", texts.of("window.ladder.detail")), BorderLayout.NORTH);
        add(parts, BorderLayout.CENTER);
        add(note, BorderLayout.SOUTH);
        title.addMouseListener(new MouseAdapter() {
            @Override
            public void mouseClicked(MouseEvent event) {
                explain();
            }
        });
        setMinimumSize(new Dimension(0, 0));
        dress();
    }

    void show(LadderRow row) {
        shown = MessageFields.of(row, language);
        String way = row.entry().from() + " \u2192 " + row.entry().to();
        String ciphered = row.entry().isCiphered() ? "   " + texts.of("window.ladder.ciphered") : "";
        title.setText(row.entry().name() + "   " + way + "   " + row.clock() + ciphered);
        title.setToolTipText(title.getText());
        fields.show(shown.fields());
        octets.show(shown.octets());
        note.explain("");
    }

    /** Explains the message by its name, or hides the explanation. */
    void explain() {
        if (shown == null || note.isVisible()) {
            note.explain("");
        } else {
            note.explainMessage(shown.name());
        }
    }

    private void fieldChosen() {
        int field = fields.getSelectedRow();
        if (!isFollowing && shown != null && field >= 0) {
            fields.scrollRectToVisible(fields.getCellRect(field, 0, true));
            octets.mark(shown.octetsOf(field), shown.fields().get(field).name());
            note.explain(shown.fields().get(field).name());
        }
    }

    private void octetChosen(int octet) {
        int field = shown.fieldAt(octet);
        isFollowing = true;
        if (field >= 0) {
            fields.setRowSelectionInterval(field, field);
            fields.scrollRectToVisible(fields.getCellRect(field, 0, true));
            octets.mark(shown.octetsOf(field), shown.fields().get(field).name());
        } else {
            fields.clearSelection();
            octets.mark(new BitSet(), octet < 2 ? texts.of("window.ladder.header") : "");
        }
        isFollowing = false;
    }

    @Override
    protected void dress() {
        title.setFont(Theme.strong());
        title.setBorder(Theme.padding(8, 2, 6, 2));
    }

    /** Puts fields and octets in a row if both fit, else one above the other. */
    private final class Parts implements Arrange.FixedLayout {
        @Override
        public Dimension preferredLayoutSize(Container parent) {
            return new Dimension(
                    Theme.px(LEAST_FIELDS_UNITS) + octetsWidth(OCTETS_PER_LINE), octetPane.getPreferredSize().height);
        }

        @Override
        public Dimension minimumLayoutSize(Container parent) {
            return new Dimension(0, 0);
        }

        private int octetsWidth(int perLine) {
            return HexDump.widthOf(perLine) + octetPane.getVerticalScrollBar().getPreferredSize().width + Theme.px(4);
        }

        @Override
        public void layoutContainer(Container parent) {
            int gap = Theme.px(Theme.GRID);
            int width = parent.getWidth();
            int height = parent.getHeight();
            int least = Theme.px(LEAST_FIELDS_UNITS);
            int right = octetsWidth(OCTETS_PER_LINE);
            if (width - gap - right < least) {
                right = octetsWidth(LEAST_OCTETS_PER_LINE);
            }
            if (width - gap - right >= least) {
                fieldPane.setBounds(0, 0, width - gap - right, height);
                octetPane.setBounds(width - right, 0, right, height);
            } else {
                int lower = (int) (height * LOWER_SHARE);
                fieldPane.setBounds(0, 0, width, height - lower - gap);
                octetPane.setBounds(0, height - lower, width, lower);
            }
        }
    }
}
