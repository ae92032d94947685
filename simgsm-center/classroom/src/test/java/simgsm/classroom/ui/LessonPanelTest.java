package simgsm.classroom.ui;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import java.awt.event.KeyEvent;
import java.io.File;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.stream.Stream;
import javax.swing.JButton;
import javax.swing.JFileChooser;
import javax.swing.JScrollPane;
import javax.swing.JTextField;
import javax.swing.KeyStroke;
import javax.swing.ScrollPaneConstants;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;
import simgsm.draw.Appearance;
import simgsm.lesson.Lesson;
import simgsm.lesson.LessonAction;
import simgsm.lesson.LessonLibrary;
import simgsm.ui.ComponentNames;
import simgsm.ui.Lamp;
import simgsm.ui.Theme;
import simgsm.ui.glossary.GlossaryText;

class LessonPanelTest {
    private final List<String> done = new ArrayList<>();

    private final LessonActions actions = new LessonActions() {
        @Override
        public void predict(String text) {
            done.add("predict " + text);
        }

        @Override
        public void answer(String name, String text) {
            done.add("answer " + name + " " + text);
        }

        @Override
        public void hint(String step) {
            done.add("hint " + step);
        }

        @Override
        public void act(String name, String input) {
            done.add("act " + name + " " + input);
        }

        @Override
        public void startProgram(String name) {
            done.add("start " + name);
        }

        @Override
        public void stopProgram(String name) {
            done.add("stop " + name);
        }

        @Override
        public void save(String student) {
            done.add("save " + student);
        }

        @Override
        public void open(String lesson) {
            done.add("open " + lesson);
        }
    };

    @BeforeEach
    void look() {
        Theme.install(Appearance.LIGHT);
    }

    private final LessonLibrary library = LessonLibrary.ofSuite();

    private LessonPanel panel(String name, String language) throws Exception {
        Locale locale = Locale.forLanguageTag(language);
        Lesson lesson = library.lesson(name);
        return new LessonPanel(lesson, library.texts(lesson, locale), library.names(), locale, text -> text, actions);
    }

    private static LessonView view(String name, LessonView.StepState state) throws Exception {
        Lesson lesson = LessonLibrary.ofSuite().lesson(name);
        return new LessonView(
                5,
                true,
                lesson.steps().stream()
                        .map(step -> new LessonView.StepView(step.name(), state, false, ""))
                        .toList(),
                Set.of(),
                "");
    }

    /** 0123... in one word, as octets are. */
    @Test
    void aNoticeMovesNoButtonIsReadToItsEndAndIsGoneOnceItIsClosedUntilThereIsAnother() throws Exception {
        LessonPanel panel = panel("twelve-keys", "en");
        panel.setSize(340, 600);
        LessonView quiet = view("twelve-keys", LessonView.StepState.OPEN);
        panel.show(quiet);
        arrange(panel);
        int before = boundsOf(panel, "lesson.save").y;
        panel.show(noticed(quiet, "The robot has hung up: " + "0123456789abcdef".repeat(20)));
        arrange(panel);
        assertEquals(before, boundsOf(panel, "lesson.save").y);
        assertTrue(boundsOf(panel, "lesson.notice").width <= 340);
        assertTrue(
                boundsOf(panel, "lesson.notice").height > 80,
                boundsOf(panel, "lesson.notice").toString());
        ((JButton) ComponentNames.find(panel, "lesson.notice.close").orElseThrow()).doClick(0);
        assertFalse(isShown(panel, "lesson.notice"));
        panel.show(noticed(quiet, "The robot has hung up: " + "0123456789abcdef".repeat(20)));
        assertFalse(isShown(panel, "lesson.notice"));
        panel.show(noticed(quiet, "Saved"));
        assertTrue(isShown(panel, "lesson.notice"));
    }

    /** Texts are measured anew after each layout, on the event thread. */
    private static void arrange(LessonPanel panel) throws Exception {
        for (int i = 0; i < 4; i++) {
            SwingUtilities.invokeAndWait(() -> lay(panel));
        }
    }

    private static void lay(java.awt.Container container) {
        container.doLayout();
        for (java.awt.Component child : container.getComponents()) {
            if (child instanceof java.awt.Container inner) {
                lay(inner);
            }
        }
    }

    private static LessonView noticed(LessonView view, String notice) {
        return new LessonView(view.seed(), true, view.steps(), view.running(), notice);
    }

    private static java.awt.Rectangle boundsOf(LessonPanel panel, String name) {
        java.awt.Component found = ComponentNames.find(panel, name).orElseThrow();
        return SwingUtilities.convertRectangle(found.getParent(), found.getBounds(), panel);
    }

    @Test
    void aLessonCanBeBegunAgain() throws Exception {
        JButton again = (JButton)
                ComponentNames.find(panel("twelve-keys", "es"), "lesson.again").orElseThrow();
        again.doClick();
        assertEquals(List.of("open twelve-keys"), done);
    }

    static Stream<String> names() {
        return LessonLibrary.ofSuite().names().stream();
    }

    @ParameterizedTest
    @MethodSource("names")
    void everyControlOfEveryLessonIsNamedInBothLanguages(String name) throws Exception {
        for (String language : List.of("en", "es")) {
            LessonPanel panel = panel(name, language);
            panel.show(view(name, LessonView.StepState.OPEN));
            assertEquals(List.of(), ComponentNames.unnamed(panel));
        }
    }

    @Test
    void theStepsAppearWithThePredictionAndTheQuestionAtTheEnd() throws Exception {
        LessonPanel panel = panel("twelve-keys", "en");
        panel.show(new LessonView(
                5, false, view("twelve-keys", LessonView.StepState.OPEN).steps(), Set.of(), ""));
        assertFalse(isShown(panel, "lesson.lamp.call"));
        panel.show(view("twelve-keys", LessonView.StepState.OPEN));
        assertTrue(isShown(panel, "lesson.lamp.call"));
        assertFalse(isShown(panel, "lesson.question"));
        panel.show(view("twelve-keys", LessonView.StepState.DONE));
        assertTrue(isShown(panel, "lesson.question"));
        Lamp lamp = (Lamp) ComponentNames.find(panel, "lesson.lamp.call").orElseThrow();
        assertEquals("done", lamp.word());
    }

    @Test
    void stepsAreNumberedCountedAndGreenWhenDone() throws Exception {
        LessonPanel panel = panel("break-it", "en");
        panel.show(new LessonView(
                5,
                true,
                library.lesson("break-it").steps().stream()
                        .map(step -> new LessonView.StepView(
                                step.name(),
                                step.name().equals("half") ? LessonView.StepState.DONE : LessonView.StepState.SPOILT,
                                false,
                                "2/6"))
                        .toList(),
                Set.of(),
                ""));
        assertTrue(textOf(panel, "lesson.step.half").startsWith("2. Find"), textOf(panel, "lesson.step.half"));
        Lamp spoilt = (Lamp) ComponentNames.find(panel, "lesson.lamp.tried").orElseThrow();
        assertEquals("This try does not count; begin another one", spoilt.word());
        assertTrue(rowOf(panel, "half").isOpaque());
        assertFalse(rowOf(panel, "tried").isOpaque());
        assertFalse(isShown(panel, "lesson.success"));
        panel.show(view("break-it", LessonView.StepState.DONE));
        assertTrue(isShown(panel, "lesson.success"));
    }

    private static String textOf(LessonPanel panel, String name) {
        return ((GlossaryText) ComponentNames.find(panel, name).orElseThrow()).getText();
    }

    private static StepRow rowOf(LessonPanel panel, String step) {
        return (StepRow) SwingUtilities.getAncestorOfClass(
                StepRow.class, ComponentNames.find(panel, "lesson.lamp." + step).orElseThrow());
    }

    @Test
    void whatIsCountedStandsBesideTheState() throws Exception {
        LessonPanel panel = panel("break-it", "en");
        panel.show(new LessonView(
                5,
                true,
                library.lesson("break-it").steps().stream()
                        .map(step -> new LessonView.StepView(step.name(), LessonView.StepState.OPEN, false, "2/6"))
                        .toList(),
                Set.of(),
                ""));
        Lamp lamp = (Lamp) ComponentNames.find(panel, "lesson.lamp.tried").orElseThrow();
        assertEquals("open, 2/6", lamp.word());
    }

    @Test
    void theNextOpenStepIsScrolledIntoViewWhenOneIsDone() throws Exception {
        LessonPanel panel = panel("one-message", "en");
        panel.setSize(340, 500);
        panel.show(view("one-message", LessonView.StepState.OPEN));
        arrange(panel);
        JScrollPane scroll = (JScrollPane) SwingUtilities.getAncestorOfClass(
                JScrollPane.class, ComponentNames.find(panel, "lesson.task").orElseThrow());
        assertEquals(0, scroll.getViewport().getViewPosition().y);
        List<LessonView.StepView> steps =
                new ArrayList<>(view("one-message", LessonView.StepState.DONE).steps());
        steps.set(6, new LessonView.StepView("type", LessonView.StepState.OPEN, false, ""));
        panel.show(new LessonView(5, true, steps, Set.of(), ""));
        arrange(panel);
        java.awt.Rectangle seen = scroll.getViewport().getViewRect();
        java.awt.Rectangle next = SwingUtilities.convertRectangle(
                rowOf(panel, "type").getParent(),
                rowOf(panel, "type").getBounds(),
                scroll.getViewport().getView());
        assertTrue(seen.contains(next), seen + " " + next);
    }

    @Test
    void anOpenedHintIsTold() throws Exception {
        LessonPanel panel = panel("break-it", "en");
        panel.show(view("break-it", LessonView.StepState.OPEN));
        JButton hint =
                (JButton) ComponentNames.find(panel, "lesson.hint.of.half").orElseThrow();
        hint.doClick();
        hint.doClick();
        assertEquals(List.of("hint half"), done);
    }

    @Test
    void tabReachesTheNextFieldBeforeAnyLink() throws Exception {
        LessonPanel panel = panel("write-a-submit", "en");
        panel.show(view("write-a-submit", LessonView.StepState.OPEN));
        panel.addNotify();
        List<String> order = new ArrayList<>();
        Component at = panel.getFocusTraversalPolicy().getFirstComponent(panel);
        while (at != null && !order.contains(at.getName())) {
            order.add(at.getName());
            at = panel.getFocusTraversalPolicy().getComponentAfter(panel, at);
        }
        panel.removeNotify();
        int link = order.indexOf("lesson.title");
        for (String field : List.of("lesson.answer.address", "lesson.answer.length", "lesson.action.send")) {
            assertTrue(order.contains(field) && order.indexOf(field) < link, field + " in " + order);
        }
    }

    @Test
    void thePartsOfAMessageAreAboveTheWhole() throws Exception {
        LessonPanel panel = panel("write-a-submit", "en");
        panel.show(view("write-a-submit", LessonView.StepState.OPEN));
        panel.setSize(340, 900);
        arrange(panel);
        int whole = boundsOf(panel, "lesson.action.send").y;
        assertTrue(boundsOf(panel, "lesson.answer.length").y < whole);
        assertTrue(whole < boundsOf(panel, "lesson.step.decoded").y);
    }

    @ParameterizedTest
    @MethodSource("names")
    void underlinedWordsAreAnnouncedWhereThereAreSome(String name) throws Exception {
        LessonPanel panel = panel(name, "en");
        boolean isUnderlined = Stream.of("lesson.title", "lesson.task", "lesson.predict.text")
                .map(each -> ComponentNames.find(panel, each).orElseThrow())
                .anyMatch(Component::isFocusable);
        isUnderlined |= library.lesson(name).steps().stream()
                .anyMatch(step -> ComponentNames.find(panel, "lesson.step." + step.name())
                        .orElseThrow()
                        .isFocusable());
        GlossaryText about =
                (GlossaryText) ComponentNames.find(panel, "lesson.about").orElseThrow();
        assertEquals(isUnderlined, about.getText().contains("Underlined"));
    }

    private static boolean isShown(LessonPanel panel, String name) {
        for (java.awt.Component each = ComponentNames.find(panel, name).orElseThrow();
                each != panel;
                each = each.getParent()) {
            if (!each.isVisible()) {
                return false;
            }
        }
        return true;
    }

    @Test
    void fieldsAndButtonsPassOnWhatTheStudentDoes() throws Exception {
        LessonPanel panel = panel("store-and-forward", "en");
        panel.show(view("store-and-forward", LessonView.StepState.OPEN));
        type(panel, "lesson.predict", "nothing");
        type(panel, "lesson.answer.first-time", " a ");
        ((JButton) ComponentNames.find(panel, "lesson.program.robot").orElseThrow()).doClick();
        ((JButton) ComponentNames.find(panel, "lesson.save").orElseThrow()).doClick();
        assertEquals(List.of("predict nothing", "answer first-time a", "start robot", "save "), done);
    }

    private static void type(LessonPanel panel, String name, String text) {
        JTextField field = (JTextField) ComponentNames.find(panel, name).orElseThrow();
        field.setText(text);
        field.postActionEvent();
    }

    @Test
    void aTermOfTheGlossaryIsExplainedAtAClick() throws Exception {
        GlossaryText text = new GlossaryText(
                "sample", java.util.Optional.of(simgsm.ui.glossary.Glossary.in(Locale.ENGLISH)), done::add);
        text.show("A SUBMIT is a TPDU");
        text.fireHyperlinkUpdate(new javax.swing.event.HyperlinkEvent(
                text, javax.swing.event.HyperlinkEvent.EventType.ACTIVATED, null, "SUBMIT"));
        assertEquals(List.of("SUBMIT"), done);
        assertEquals("A SUBMIT is a TPDU", text.getText());
    }

    @Test
    void aTermIsReachedAndChosenByKeys() {
        GlossaryText text = new GlossaryText(
                "sample", java.util.Optional.of(simgsm.ui.glossary.Glossary.in(Locale.ENGLISH)), done::add);
        text.show("No link.");
        assertFalse(text.isFocusable());
        text.show("A SUBMIT is a TPDU");
        text.setSize(200, 100);
        assertTrue(text.isFocusable());
        assertTrue(text.getFocusTraversalKeys(java.awt.KeyboardFocusManager.FORWARD_TRAVERSAL_KEYS)
                .contains(KeyStroke.getKeyStroke(KeyEvent.VK_TAB, 0)));
        press(text, KeyEvent.VK_RIGHT);
        press(text, KeyEvent.VK_ENTER);
        press(text, KeyEvent.VK_RIGHT);
        press(text, KeyEvent.VK_SPACE);
        press(text, KeyEvent.VK_LEFT);
        press(text, KeyEvent.VK_ENTER);
        assertEquals(List.of("SUBMIT", "TPDU", "SUBMIT"), done);
    }

    private static void press(GlossaryText text, int key) {
        Object action = text.getInputMap().get(KeyStroke.getKeyStroke(key, 0));
        text.getActionMap().get(action).actionPerformed(new java.awt.event.ActionEvent(text, 0, ""));
    }

    @ParameterizedTest
    @CsvSource({"forge-an-order, wav", "who-is-it, sim", "your-first-behaviour, java"})
    void theChooserShowsTheFilesThatAreHandedIn(String lesson, String ending) throws Exception {
        LessonAction.File file = library.lesson(lesson).actions().stream()
                .map(LessonAction::input)
                .filter(LessonAction.File.class::isInstance)
                .map(LessonAction.File.class::cast)
                .findFirst()
                .orElseThrow();
        assertEquals(ending, file.ending());
        JFileChooser chooser = panel(lesson, "es").chooser("Entregar", file.ending());
        assertEquals("Entregar", chooser.getDialogTitle());
        assertEquals("Archivos *." + ending, chooser.getFileFilter().getDescription());
        assertTrue(chooser.accept(new File("mine." + ending)));
        assertFalse(chooser.accept(new File("mine.txt")));
    }

    @Test
    void theTextsKeepTheirWidthWhenThePanelGrowsBeyondItsWindow() throws Exception {
        LessonPanel panel = panel("walk-through-town", "es");
        JScrollPane scroll = (JScrollPane) SwingUtilities.getAncestorOfClass(
                JScrollPane.class, ComponentNames.find(panel, "lesson.task").orElseThrow());
        assertEquals(ScrollPaneConstants.VERTICAL_SCROLLBAR_ALWAYS, scroll.getVerticalScrollBarPolicy());
    }

    /** Changed appearance, and colours and fonts of every component as of one that was built in it. */
    @ParameterizedTest
    @EnumSource
    void aPanelLooksInANewAppearanceAsOneThatWasBuiltInIt(Appearance next) throws Exception {
        Theme.install(next.next());
        LessonPanel changed = panel("store-and-forward", "es");
        changed.show(noticed(view("store-and-forward", LessonView.StepState.OPEN), "Saved"));
        Theme.install(next);
        Theme.refresh(changed);
        LessonPanel built = panel("store-and-forward", "es");
        built.show(noticed(view("store-and-forward", LessonView.StepState.OPEN), "Saved"));
        assertEquals(Looks.of(built), Looks.of(changed));
    }

    @Test
    void noFrameAndNoCloseButtonStandBeforeANotice() throws Exception {
        LessonPanel panel = panel("twelve-keys", "en");
        LessonView quiet = view("twelve-keys", LessonView.StepState.OPEN);
        panel.show(quiet);
        assertFalse(isShown(panel, "lesson.notice.close"));
        panel.show(noticed(quiet, "Saved"));
        assertTrue(isShown(panel, "lesson.notice.close"));
    }
}
