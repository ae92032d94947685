package simgsm.modem.client;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import simgsm.dtmf.DtmfGenerator;
import simgsm.dtmf.DtmfKey;
import simgsm.modem.VoiceStore;
import simgsm.modem.line.ModemLine;
import simgsm.speech.CallAudioListener;
import simgsm.speech.PcmFrames;
import simgsm.words.FrontEnd;
import simgsm.words.PromptListener;
import simgsm.words.Prompts;
import simgsm.words.SpeakerTemplates;
import simgsm.words.SpeechFrame;
import simgsm.words.SpokenLanguage;
import simgsm.words.SpokenWord;
import simgsm.words.Utterance;
import simgsm.words.WordCutter;

/** Words in the sound of a real modem's calls, said and heard; the caller's voice is that of the prompts. */
class AttachedWordsTest {
    private static final Prompts PROMPTS = Prompts.of(SpokenLanguage.ENGLISH);
    private static final List<String> WORDS = List.of(
            "forward", "turn", "right", "stop", "status", "yes", "no", "zero", "one", "two", "three", "four", "five",
            "six", "seven", "eight", "nine");

    private final List<String> said = new ArrayList<>();
    private final PromptListener farEnd = new PromptListener(sentence -> said.add(sentence.text()));
    private final PcmFrames fromRobot = new PcmFrames(farEnd::accept);
    private final Random random = new Random(1);
    private final ModemBench bench = new ModemBench(
            1500,
            new SoundPort(
                    fromRobot::accept, CallAudioListener.NONE, Optional.of(PROMPTS), Optional.of(new Enrolled())));
    private final ModemLine.Party sound = bench.modem.sound();

    /** All words, four times each, of any caller. */
    private static final class Enrolled implements VoiceStore {
        @Override
        public SpeakerTemplates read(String caller) {
            assertEquals("5550100", caller);
            SpeakerTemplates templates = new SpeakerTemplates();
            for (int i = 0; i < 4 * WORDS.size(); i++) {
                String word = WORDS.get(i / 4);
                List<SpeechFrame> frames = new ArrayList<>();
                FrontEnd frontEnd = new FrontEnd(frames::add);
                frontEnd.accept(new short[1600]);
                frontEnd.accept(PROMPTS.samples(new Utterance(List.of(word))));
                frontEnd.accept(new short[4000]);
                templates.add(word, SpokenWord.of(WordCutter.cut(frames).orElseThrow()));
            }
            return templates;
        }

        @Override
        public void add(String caller, String word, int number, SpokenWord template) {
            throw new AssertionError("nothing is to be enrolled");
        }
    }

    @BeforeAll
    static void load() {
        PromptListener.load();
    }

    private void hear(short[] samples) {
        for (int at = 0; at < samples.length; at += 160) {
            short[] frame = Arrays.copyOfRange(samples, at, at + 160);
            for (int i = 0; i < frame.length; i++) {
                frame[i] += (short) (random.nextGaussian() * 20);
            }
            bench.millis(20);
            sound.received(PcmFrames.octets(frame), bench.nowNanos);
        }
    }

    private void silence(int millis) {
        hear(new short[8 * millis]);
    }

    private void press(String keys) {
        DtmfGenerator caller = new DtmfGenerator();
        DtmfKey.sequence(keys).forEach(key -> caller.enqueue(key, 100, 100));
        short[] samples = new short[1600 * keys.length()];
        caller.read(samples);
        hear(samples);
    }

    private void speak(String... words) {
        for (String word : words) {
            silence(200);
            hear(PROMPTS.samples(new Utterance(List.of(word))));
            silence(400);
        }
    }

    private long count(String event) {
        return bench.news().stream().filter(event::equals).count();
    }

    private void openAndCall() {
        AttachedSoundTest.DtmfDialectAnswers.refuseAll(bench);
        bench.answers.put("AT^CVOICE?", "^CVOICE:0,8000,16,20|OK");
        sound.lineUp(bench.nowNanos);
        bench.ready().inCall();
        silence(1000);
        bench.news();
    }

    @Test
    void aReplyIsSaidAfterItsToneAndAKeyEndsIt() {
        openAndCall();
        assertTrue(bench.modem.sendTone(DtmfKey.of('3')));
        assertTrue(bench.modem.say("Stopped"));
        silence(3000);
        assertEquals(List.of("Stopped"), said);
        assertEquals(1, count("WordsBegun"));
        bench.modem.say("Not a valid command");
        silence(400);
        press("5");
        silence(3000);
        assertEquals(List.of("Stopped"), said);
    }

    @Test
    void anOrderByVoiceIsReadBackAndConfirmedByAKeyThatIsNoneOfTheOrder() {
        openAndCall();
        assertTrue(bench.modem.listensToVoice());
        bench.modem.listen();
        silence(3000);
        speak("forward", "two", "zero");
        silence(4000);
        assertEquals(List.of("Say forward turn stop or status", "Forward two zero say yes"), said);
        assertEquals(3, count("WordHeard"));
        press("#");
        List<String> news = bench.news();
        assertTrue(news.contains("OrderSpoken"), news.toString());
        assertFalse(news.stream().anyMatch(event -> event.startsWith("key ")), news.toString());
    }

    @Test
    void withoutItsSoundNothingIsSaidAndNobodyIsHeard() {
        openAndCall();
        sound.lineDown(bench.nowNanos);
        assertFalse(bench.modem.say("Stopped"));
        assertFalse(bench.modem.listensToVoice(), "*# is not for the words");
        bench.modem.listen();
        bench.millis(3000);
        assertEquals(List.of(), said);
    }
}
