package simgsm.center.ui;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.ResourceBundle;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import simgsm.center.msc.ExchangeSnapshot.MessageRow;
import simgsm.center.smsc.DeliveryAttempt;
import simgsm.center.smsc.DeliveryOutcome;
import simgsm.center.smsc.MessageHistory;
import simgsm.center.smsc.MessageState;
import simgsm.center.smsc.WaitReason;
import simgsm.console.TextBundle;

class HistoryWordsTest {
    private static TextBundle texts(String language) {
        Locale locale = Locale.forLanguageTag(language);
        return new TextBundle(ResourceBundle.getBundle("simgsm.center.app.messages", locale), locale);
    }

    private static MessageHistory history(MessageState state, WaitReason standing, DeliveryOutcome outcome) {
        MessageHistory waiting = Scene.waiting();
        return new MessageHistory(
                waiting.message(),
                state,
                standing,
                List.of(new DeliveryAttempt(Scene.NOON, outcome)),
                30,
                waiting.nextTry(),
                standing == WaitReason.ENDED ? Optional.of(Scene.NOON) : Optional.empty());
    }

    @Test
    void theCourseOfAMessageThatWaitsIsReportedInOrder() {
        List<String> lines = HistoryWords.lines(Scene.waiting(), texts("en"));
        assertEquals("Message 1 from 5550100 to 5550201", lines.get(0));
        assertTrue(lines.get(1).endsWith(" accepted and stored"), lines.get(1));
        assertTrue(lines.get(2).endsWith(" tried: memory capacity exceeded (22)"), lines.get(2));
        assertTrue(lines.get(3).endsWith(" next try"), lines.get(3));
        assertEquals("Tried as soon as the receiver says that it has room, or by the schedule.", lines.get(4));
        assertTrue(lines.get(5).startsWith("Expires 2026-11-2"), lines.get(5));
        assertEquals(6, lines.size());
    }

    @Test
    void aMessageThatHasEndedSaysHowAndWhatIsForgottenOfIt() {
        List<String> lines = HistoryWords.lines(
                history(MessageState.EXPIRED, WaitReason.ENDED, DeliveryOutcome.FAILED), texts("en"));
        assertEquals("... 29 earlier attempts", lines.get(2));
        assertTrue(lines.get(lines.size() - 1).endsWith(" ended: expired"), lines.toString());
    }

    @ParameterizedTest
    @ValueSource(strings = {"en", "es"})
    void everyOutcomeHasWords(String language) {
        for (DeliveryOutcome outcome : DeliveryOutcome.values()) {
            String all = HistoryWords.lines(
                            history(MessageState.ACCEPTED, WaitReason.AWAITING_RETRY, outcome), texts(language))
                    .toString();
            assertFalse(all.contains("window."), all);
        }
    }

    @ParameterizedTest
    @EnumSource(WaitReason.class)
    void everyStandingHasAWordAndAMark(WaitReason standing) {
        for (MessageState state : MessageState.values()) {
            if (standing == WaitReason.ENDED && state == MessageState.ACCEPTED) {
                continue;
            }
            for (String language : List.of("en", "es")) {
                MessageRow row = new MessageRow("x", history(state, standing, DeliveryOutcome.ABSENT));
                String word = HistoryWords.state(row, texts(language)).word();
                assertFalse(word.contains("window."), word);
            }
        }
    }
}
