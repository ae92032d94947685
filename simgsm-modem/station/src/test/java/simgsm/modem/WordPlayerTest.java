package simgsm.modem;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import simgsm.words.Prompts;
import simgsm.words.SpokenLanguage;

class WordPlayerTest {
    private final List<String> begun = new ArrayList<>();
    private final WordPlayer player = new WordPlayer(Prompts.of(SpokenLanguage.ENGLISH), begun::add);

    /** @return true if the frame has words */
    private boolean passes(boolean isTone) {
        short[] frame = new short[160];
        frame[0] = 1;
        player.read(frame, isTone);
        return frame[0] != 1 || frame[1] != 0;
    }

    private int framesOfWords() {
        int count = 0;
        while (passes(false)) {
            count++;
        }
        return count;
    }

    @Test
    void wordsBeginTwoHundredMillisecondsAfterTheLastTone() {
        player.say("Not possible: no motors.");
        assertFalse(passes(true));
        for (int i = 0; i < WordPlayer.PAUSE_FRAMES; i++) {
            assertFalse(passes(false));
        }
        assertEquals(List.of(), begun);
        assertTrue(passes(false));
        assertEquals(List.of("Not possible no motors"), begun);
        assertTrue(framesOfWords() > 50);
        assertFalse(passes(false));
    }

    @Test
    void stoppedWordsStaySilentAndLaterOnesBeginFromTheirStart() {
        player.say("Battery low.");
        for (int i = 0; i < WordPlayer.PAUSE_FRAMES + 3; i++) {
            passes(false);
        }
        player.stop();
        assertFalse(passes(false));
        player.say("Started process 1: wander.");
        assertTrue(passes(false));
        assertEquals(List.of("Battery low", "Started process one"), begun);
    }

    @Test
    void aReplyWithoutAnyPromptIsSilent() {
        player.say("Process wander ended: no way");
        for (int i = 0; i < 20; i++) {
            assertFalse(passes(false));
        }
        assertEquals(List.of(), begun);
    }
}
