package simgsm.modem;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.Stream;
import simgsm.dtmf.DtmfKey;
import simgsm.words.FrontEnd;
import simgsm.words.HeardWord;
import simgsm.words.SpeakerTemplates;
import simgsm.words.SpeechFrame;
import simgsm.words.SpokenLanguage;
import simgsm.words.SpokenWord;
import simgsm.words.Utterance;
import simgsm.words.WordComparison;
import simgsm.words.WordCutter;

/**
 * Takes orders by voice: one command, read back, executed after "yes" or {@code #}. A caller without templates enrols
 * first. Any other key closes it. It hears nothing while the modem speaks. A core; its time is the caller's speech.
 */
final class VoiceDialogue {
    /** Silence after which a command with a number is complete, 1.5 s. */
    private static final int COMPLETE_SAMPLES = 12_000;
    /** Silence after which a question is repeated, 5 s. */
    private static final int PATIENCE_SAMPLES = 40_000;
    /** A question is repeated so often without an understood word; then the dialogue ends. */
    private static final int MOST_REPEATS = 2;

    private enum Phase {
        CLOSED,
        ENROLLING,
        COMMAND,
        CONFIRMING
    }

    private final WordPlayer player;
    private final SpokenLanguage language;
    private final VoiceStore store;
    private final Consumer<ModemEvent> listener;
    private final WordCutter cutter = new WordCutter(this::heard);
    private final FrontEnd frontEnd = new FrontEnd(this::frame);
    private Phase phase = Phase.CLOSED;
    private String caller = "";
    private SpeakerTemplates templates = new SpeakerTemplates();
    private final List<VoiceWord> command = new ArrayList<>();
    private VoiceWord enrolled = VoiceWord.FORWARD;
    private int repeats;
    private int silentSamples;

    /** @param listener receives {@link ModemEvent.WordHeard} and {@link ModemEvent.OrderSpoken} */
    VoiceDialogue(WordPlayer player, SpokenLanguage language, VoiceStore store, Consumer<ModemEvent> listener) {
        this.player = player;
        this.language = language;
        this.store = store;
        this.listener = listener;
    }

    /** Begins to listen to a caller, or to enrol. @param number empty if the network does not give it: nothing is kept */
    void open(String number) {
        caller = number;
        templates = number.isEmpty() ? new SpeakerTemplates() : store.read(number);
        repeats = 0;
        if (nextToEnrol().isPresent()) {
            phase = Phase.ENROLLING;
            askToEnrol();
        } else {
            askForCommand();
        }
    }

    boolean isOpen() {
        return phase != Phase.CLOSED;
    }

    void close() {
        phase = Phase.CLOSED;
    }

    /** A key of the caller: {@code #} confirms; any other one closes the dialogue. @return true if it is used up */
    boolean key(DtmfKey key) {
        if (phase == Phase.CONFIRMING && key.symbol() == '#') {
            execute();
            return true;
        }
        close();
        return false;
    }

    /** Speech of the caller. */
    void hear(short[] samples) {
        if (!isOpen() || player.isSpeaking()) {
            cutter.reset();
            silentSamples = 0;
            return;
        }
        silentSamples = cutter.isInWord() ? 0 : silentSamples + samples.length;
        frontEnd.accept(samples);
        if (phase == Phase.COMMAND
                && silentSamples >= COMPLETE_SAMPLES
                && VoiceWord.keys(command).isPresent()) {
            readBack();
        } else if (isOpen() && silentSamples >= PATIENCE_SAMPLES) {
            askAgain();
        }
    }

    private void frame(SpeechFrame frame) {
        if (isOpen() && !player.isSpeaking()) {
            cutter.accept(frame);
        }
    }

    private void heard(List<SpeechFrame> frames) {
        silentSamples = 0;
        switch (phase) {
            case ENROLLING -> enrol(SpokenWord.of(frames));
            case COMMAND -> take(frames, allowed());
            case CONFIRMING -> take(frames, List.of(VoiceWord.YES, VoiceWord.NO));
            case CLOSED -> {}
        }
    }

    /** Words that may follow; a command may begin again at any time. */
    private List<VoiceWord> allowed() {
        return Stream.concat(VoiceWord.after(command).stream(), VoiceWord.after(List.of()).stream())
                .distinct()
                .toList();
    }

    private void take(List<SpeechFrame> frames, List<VoiceWord> words) {
        Optional<WordComparison> compared = templates.compare(
                frames, words.stream().map(VoiceWord::template).toList());
        compared.ifPresent(word -> listener.accept(new ModemEvent.WordHeard(word)));
        Optional<HeardWord> found = compared.map(WordComparison::result);
        if (found.isEmpty() || !found.get().isSure()) {
            askAgain();
            return;
        }
        repeats = 0;
        VoiceWord taken = VoiceWord.ofTemplate(found.get().word());
        if (phase == Phase.CONFIRMING) {
            if (taken == VoiceWord.YES) {
                execute();
            } else {
                askForCommand();
            }
            return;
        }
        if (VoiceWord.after(List.of()).contains(taken)) {
            command.clear();
        }
        command.add(taken);
        if (VoiceWord.after(command).isEmpty()) {
            readBack();
        }
    }

    private void readBack() {
        phase = Phase.CONFIRMING;
        List<String> prompts = new ArrayList<>();
        command.forEach(word -> prompts.add(word.prompt(language)));
        prompts.add(prompt("say yes", "diga sí"));
        say(prompts);
    }

    private void execute() {
        close();
        listener.accept(new ModemEvent.OrderSpoken(VoiceWord.keys(command).orElseThrow()));
    }

    private void askForCommand() {
        phase = Phase.COMMAND;
        command.clear();
        askForWord();
    }

    /** Says which words may come next: "say right or zero to nine". */
    private void askForWord() {
        List<String> prompts = new ArrayList<>(List.of(prompt("say", "diga")));
        for (VoiceWord word : VoiceWord.after(command)) {
            boolean isLast = word == VoiceWord.STATUS || word == VoiceWord.ZERO;
            if (isLast && prompts.size() > 1) {
                prompts.add(prompt("or", "o"));
            }
            if (word == VoiceWord.NINE) {
                prompts.add(prompt("to", "a"));
            }
            if (!word.isDigit() || word == VoiceWord.ZERO || word == VoiceWord.NINE) {
                prompts.add(word.prompt(language));
            }
        }
        say(prompts);
    }

    /** Repeats the question twice, then refers to the keys and ends. */
    private void askAgain() {
        silentSamples = 0;
        if (++repeats > MOST_REPEATS) {
            close();
            say(List.of(prompt("use the keys", "use las teclas")));
        } else if (phase == Phase.ENROLLING) {
            askToEnrol();
        } else if (phase == Phase.COMMAND) {
            askForWord();
        } else {
            say(List.of(prompt("say it again", "repita")));
        }
    }

    private void askToEnrol() {
        enrolled = nextToEnrol().orElseThrow();
        say(List.of(prompt("say", "diga"), enrolled.prompt(language)));
    }

    /** Two rounds of two templates a word. */
    private Optional<VoiceWord> nextToEnrol() {
        for (int wanted : new int[] {SpeakerTemplates.MOST / 2, SpeakerTemplates.MOST}) {
            Optional<VoiceWord> next = Arrays.stream(VoiceWord.values())
                    .filter(word -> templates.count(word.template()) < wanted)
                    .findFirst();
            if (next.isPresent()) {
                return next;
            }
        }
        return Optional.empty();
    }

    /** Keeps the word, unless another one's templates are nearer than its own: then it is asked again. */
    private void enrol(SpokenWord word) {
        String name = enrolled.template();
        boolean isKnown = templates.count(name) > 0;
        boolean isOther = isKnown
                && templates
                        .hear(word, templates.words())
                        .filter(found -> !found.word().equals(name))
                        .isPresent();
        if (isOther && repeats < MOST_REPEATS) {
            askAgain();
            return;
        }
        repeats = 0;
        templates.add(name, word);
        if (!caller.isEmpty()) {
            store.add(caller, name, templates.count(name), word);
        }
        if (nextToEnrol().isPresent()) {
            askToEnrol();
        } else {
            askForCommand();
        }
    }

    private String prompt(String english, String spanish) {
        return language == SpokenLanguage.SPANISH ? spanish : english;
    }

    private void say(List<String> prompts) {
        player.say(new Utterance(prompts));
    }
}
