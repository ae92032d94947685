package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** The centre dies without a word, again and again, in the middle of traffic. */
class NothingIsLostTest {
    private static final int DEATHS = 3;
    private static final int MESSAGES_PER_LIFE = 30;

    @Test
    void whateverWasAcknowledgedIsShownOnceThoughTheCentreIsKilledUnderLoad() throws Exception {
        try (Scenario scenario = new Scenario("the centre is killed under load, again and again")) {
            RunningProgram center = scenario.center();
            RunningProgram alice = scenario.phone("5550100");
            RunningProgram bob = scenario.phone("5550101");
            List<String> texts = new ArrayList<>();
            for (int life = 0; life < DEATHS; life++) {
                for (int i = 0; i < MESSAGES_PER_LIFE; i++) {
                    texts.add("life " + life + " message " + i);
                    alice.say("sms 5550101 " + texts.get(texts.size() - 1));
                }
                for (int i = 0; i < 5 + 10 * life; i++) {
                    alice.expect("sms-sent");
                }
                center.kill();
                center = scenario.centerAgain();
            }
            alice.say("sms 5550101 the last");
            bob.expect("sms", "text", "the last");
            List<String> read = new ArrayList<>();
            bob.say("inbox");
            for (ConsoleEvent event = bob.expectNext("message");
                    !event.field("text").equals("the last");
                    event = bob.expectNext("message")) {
                read.add(event.field("text"));
            }
            assertEquals(texts, read, () -> alice + "\n" + bob);
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
