package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Random;
import java.util.concurrent.Semaphore;
import org.junit.jupiter.api.Test;

/** The centre dies without a word, again and again, in the middle of traffic. */
class NothingIsLostTest {
    /** {@code -Dkills=100} searches for longer; at other moments each time. */
    private static final int DEATHS = Integer.getInteger("kills", 3);

    private static final int MESSAGES_PER_LIFE = 30;
    private static final int MOST_SUBMITTED = 100;
    private static final Random RANDOM = new Random();

    @Test
    void whateverWasAcknowledgedIsShownOnceThoughTheCentreIsKilledUnderLoad() throws Exception {
        try (Scenario scenario = new Scenario("the centre is killed under load, again and again")) {
            RunningProgram center = scenario.center();
            RunningProgram alice = scenario.phone("5550100");
            RunningProgram bob = scenario.phone("5550101");
            List<String> texts = new ArrayList<>();
            for (int life = 0; life < DEATHS; life++) {
                for (int i = 0; i < MESSAGES_PER_LIFE; i++) {
                    texts.add(i % 10 == 9 ? "again" : "life " + life + " message " + i);
                    alice.say("sms 5550101 " + texts.get(texts.size() - 1));
                }
                int sent = 1 + RANDOM.nextInt(MESSAGES_PER_LIFE);
                scenario.tell("killed after " + sent + " acknowledgements");
                for (int i = 0; i < sent; i++) {
                    alice.expect("sms-sent");
                }
                center.kill();
                center = scenario.centerAgain();
            }
            alice.say("sms 5550101 the last");
            assertEquals(texts, shownBefore(bob, "the last"), () -> alice + "\n" + bob);
        }
    }

    private static List<String> shownBefore(RunningProgram phone, String last) {
        List<String> shown = new ArrayList<>();
        for (String text = phone.expect("sms").field("text");
                !text.equals(last);
                text = phone.expect("sms").field("text")) {
            shown.add(text);
        }
        return shown;
    }

    @Test
    void everyMessageAcknowledgedToAnApplicationIsShownOnceThoughTheCentreIsKilledUnderLoad() throws Exception {
        try (Scenario scenario = new Scenario("the centre is killed under an application's load")) {
            RunningProgram center = scenario.center("--smpp", "0");
            RunningProgram bob = scenario.phone("5550101");
            List<String> acknowledged = new ArrayList<>();
            for (int life = 0; life < DEATHS; life++) {
                Submitter submitter = new Submitter(scenario.smppPort(), "life " + life);
                submitter.start();
                int stored = 1 + RANDOM.nextInt(MOST_SUBMITTED);
                scenario.tell("killed after " + stored + " answers");
                submitter.awaitAnswers(stored);
                center.kill();
                acknowledged.addAll(submitter.end());
                center = scenario.centerAgain("--smpp", "0");
            }
            RunningProgram alice = scenario.phone("5550100");
            alice.say("sms 5550101 the last");
            List<String> shown = shownBefore(bob, "the last");
            assertEquals(List.copyOf(new LinkedHashSet<>(shown)), shown, "nothing is shown twice");
            // What was stored but not acknowledged any more may be there, too.
            assertTrue(shown.containsAll(acknowledged), () -> acknowledged + " were acknowledged, " + shown + " shown");
        }
    }

    /** An application that submits until its centre is gone. */
    private static final class Submitter extends Thread {
        private final SmppApplication application;
        private final String name;
        private final List<String> acknowledged = new ArrayList<>();
        private final Semaphore answers = new Semaphore(0);

        Submitter(int port, String name) throws IOException {
            this.name = name;
            application = new SmppApplication(port, "load", "", "5550300");
        }

        @Override
        public void run() {
            try (application) {
                for (int i = 0; ; i++) {
                    String text = name + " message " + i;
                    application.submit("5550101", text, false);
                    acknowledged.add(text);
                    answers.release();
                }
            } catch (IOException gone) {
                answers.release(MOST_SUBMITTED);
            }
        }

        void awaitAnswers(int count) throws InterruptedException {
            answers.acquire(count);
        }

        List<String> end() throws InterruptedException {
            join();
            return acknowledged;
        }
    }

    @Test
    void aMessageForAnAbsentPhoneOutlivesTheCentreAndKeepsItsId() throws Exception {
        try (Scenario scenario = new Scenario("a message outlives the centre")) {
            RunningProgram center = scenario.center();
            RunningProgram alice = scenario.phone("5550100");
            alice.say("sms 5550101 wait for me");
            alice.expect("sms-sent");
            String id = center.expect("sms", "state", "accepted").field("id");
            center.kill();
            RunningProgram again = scenario.centerAgain();
            alice.expect("registered");
            again.ask("messages", "queued");
            RunningProgram bob = scenario.phone("5550101");
            bob.expect("sms", "from", "5550100", "text", "wait for me");
            again.expect("sms", "id", id, "state", "delivered");
            alice.expect("sms-delivered", "to", "5550101");
        }
    }

    @Test
    void whoHasEverRegisteredIsAbsentAfterARestartAndNotUnknown() throws Exception {
        try (Scenario scenario = new Scenario("subscribers outlive the centre")) {
            RunningProgram center = scenario.center();
            RunningProgram alice = scenario.phone("5550100");
            scenario.phone("5550101").quit();
            center.kill();
            RunningProgram again = scenario.centerAgain();
            alice.expect("unregistered");
            alice.expect("registered");
            alice.say("dial 5550101");
            alice.expect("released", "cause", "27");
            alice.say("dial 5550199");
            alice.expect("released", "cause", "1");
            again.say("subscribers");
            again.expect("subscriber", "number", "5550101", "state", "detached");
        }
    }
}
