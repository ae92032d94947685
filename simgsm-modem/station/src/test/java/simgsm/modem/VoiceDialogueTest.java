package simgsm.modem;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simgsm.dtmf.DtmfKey;
import simgsm.words.Prompts;
import simgsm.words.SpeakerTemplates;
import simgsm.words.SpokenLanguage;
import simgsm.words.SpokenWord;
import simgsm.words.Utterance;

/** The caller speaks with the prompts' voice, over noise of 30 dB. */
class VoiceDialogueTest {
    private static final String CALLER = "5550100";

    private final Prompts prompts = Prompts.of(SpokenLanguage.ENGLISH);
    private final List<String> said = new ArrayList<>();
    private final List<String> orders = new ArrayList<>();
    private final List<String> heard = new ArrayList<>();
    private final WordPlayer player = new WordPlayer(prompts, said::add);
    private static final String ANY_ORDER = "Say forward turn stop or status";

    private final Kept store = new Kept();
    private final VoiceDialogue dialogue = new VoiceDialogue(player, SpokenLanguage.ENGLISH, store, this::note);
    private final Random random = new Random(1);

    /** A store in memory. */
    private static final class Kept implements VoiceStore {
        final List<String> added = new ArrayList<>();
        final List<Map.Entry<String, SpokenWord>> words = new ArrayList<>();
        SpeakerTemplates templates = new SpeakerTemplates();

        @Override
        public SpeakerTemplates read(String caller) {
            return templates;
        }

        @Override
        public void add(String caller, String word, int number, SpokenWord template) {
            added.add(caller + " " + word + " " + number);
            words.add(Map.entry(word, template));
        }
    }

    private void note(ModemEvent event) {
        if (event instanceof ModemEvent.OrderSpoken order) {
            orders.add(order.keys());
        } else if (event instanceof ModemEvent.WordHeard word) {
            heard.add(word.compared().result().word());
        }
    }

    /** Both directions of the call: the caller's frame is heard, the robot's frame is filled. */
    private void pass(short[] frame) {
        short[] noisy = frame.clone();
        for (int i = 0; i < noisy.length; i++) {
            noisy[i] += (short) (random.nextGaussian() * 40);
        }
        player.read(new short[160], false);
        dialogue.hear(noisy);
    }

    private void silence(int millis) {
        for (int i = 0; i < millis / 20; i++) {
            pass(new short[160]);
        }
    }

    /** Waits until the robot is silent, and says the word. */
    private void speak(String word) {
        while (player.isSpeaking()) {
            silence(20);
        }
        silence(200);
        short[] samples = prompts.samples(new Utterance(List.of(word)));
        for (int at = 0; at < samples.length; at += 160) {
            pass(Arrays.copyOfRange(samples, at, at + 160));
        }
        silence(400);
    }

    private void enrol() {
        dialogue.open(CALLER);
        for (int round = 0; round < 2; round++) {
            for (VoiceWord word : VoiceWord.values()) {
                speak(word.prompt(SpokenLanguage.ENGLISH));
                speak(word.prompt(SpokenLanguage.ENGLISH));
            }
        }
    }

    /** The words of a caller who enrolled once, for all tests. */
    private static final class Enrolled {
        static final List<Map.Entry<String, SpokenWord>> WORDS = words();

        private static List<Map.Entry<String, SpokenWord>> words() {
            VoiceDialogueTest first = new VoiceDialogueTest();
            first.enrol();
            return first.store.words;
        }
    }

    private void enrolledCallerCalls() {
        Enrolled.WORDS.forEach(word -> store.templates.add(word.getKey(), word.getValue()));
        dialogue.open(CALLER);
    }

    @Test
    void aNewCallerSaysEachWordFourTimesInTwoRounds() {
        enrol();
        assertEquals(17 * SpeakerTemplates.MOST, store.added.size());
        assertEquals("5550100 forward 1", store.added.get(0));
        assertEquals("5550100 forward 3", store.added.get(34));
        assertEquals("5550100 nine 4", store.added.get(67));
        silence(400);
        assertEquals(ANY_ORDER, said.get(said.size() - 1));
        assertTrue(dialogue.isOpen());
    }

    @ParameterizedTest(name = "{0}")
    @CsvSource({
        "forward two zero, Forward two zero say yes, **#**20**",
        "turn nine zero, Turn nine zero say yes, **#*#90**",
        "turn right four five, Turn right four five say yes, **#*#45**",
        "forward one two three four, Forward one two three four say yes, **#**1234**",
        "stop, Stop say yes, **###**",
        "status, Status say yes, **#*0**",
        "forward two turn one, Turn one say yes, **#*#1**"
    })
    void aCommandIsReadBackAndExecutedAfterYesOnly(String words, String readBack, String keys) {
        enrolledCallerCalls();
        for (String word : words.split(" ")) {
            speak(word);
        }
        silence(2000);
        assertEquals(readBack, said.get(said.size() - 1));
        assertEquals(List.of(), orders);
        speak("yes");
        assertEquals(List.of(keys), orders);
        assertFalse(dialogue.isOpen());
    }

    @Test
    void theKeyHashConfirmsAsYesDoesAndNoAsksForTheCommandAgain() {
        enrolledCallerCalls();
        speak("status");
        speak("no");
        assertEquals(List.of(), orders);
        speak("stop");
        silence(400);
        assertTrue(dialogue.key(DtmfKey.HASH));
        assertEquals(List.of("**###**"), orders);
        assertFalse(dialogue.key(DtmfKey.HASH));
    }

    @Test
    void anyOtherKeyClosesTheEarAndIsNotUsedUp() {
        enrolledCallerCalls();
        speak("forward");
        assertFalse(dialogue.key(DtmfKey.STAR));
        assertFalse(dialogue.isOpen());
        speak("two");
        silence(3000);
        assertEquals(List.of(), orders);
    }

    @Test
    void aSilentCallerIsAskedAgainTwiceAndThenSentToTheKeys() {
        enrolledCallerCalls();
        silence(30_000);
        assertEquals(
                List.of(ANY_ORDER, ANY_ORDER, ANY_ORDER, "Use the keys"), said.subList(said.size() - 4, said.size()));
        assertFalse(dialogue.isOpen());
    }

    @ParameterizedTest
    @CsvSource({"forward, Say zero to nine", "turn, Say right or zero to nine", "turn right, Say zero to nine"})
    void whoStopsInACommandHearsTheWordsThatMayFollow(String words, String cue) {
        enrolledCallerCalls();
        for (String word : words.split(" ")) {
            speak(word);
        }
        silence(6_000);
        assertEquals(cue, said.get(said.size() - 1));
    }

    @Test
    void aWordOutsideTheCommandIsRefusedOrAskedAgainAndNothingIsExecuted() {
        enrolledCallerCalls();
        speak("not a valid command");
        speak("thousand");
        speak("battery low");
        silence(4000);
        assertEquals(List.of(), orders);
    }
}
