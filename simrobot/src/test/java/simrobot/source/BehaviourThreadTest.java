package simrobot.source;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.lang.reflect.Proxy;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CountDownLatch;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import simrobot.behaviour.Behaviour;
import simrobot.behaviour.Senses;
import simrobot.behaviour.Steering;
import simrobot.process.Decision;
import simrobot.process.WaitBudget;

class BehaviourThreadTest {
    private static final Map<Class<?>, Object> NOTHING = Map.of(double.class, 0.0, boolean.class, false);
    private static final Senses SENSES = (Senses) Proxy.newProxyInstance(
            Senses.class.getClassLoader(),
            new Class<?>[] {Senses.class},
            (proxy, method, arguments) -> NOTHING.get(method.getReturnType()));

    private final CountDownLatch released = new CountDownLatch(1);
    private final List<BehaviourThread> threads = new ArrayList<>();

    private BehaviourThread slow(WaitBudget budget) {
        Behaviour waiting = senses -> {
            try {
                released.await();
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
            }
            return new Steering(0.5, 0);
        };
        BehaviourThread thread = new BehaviourThread("slow", () -> waiting, new FaultPlace(null), budget, false);
        threads.add(thread);
        return thread;
    }

    @AfterEach
    void end() {
        threads.forEach(BehaviourThread::close);
    }

    @Test
    void manySlowProcessesShareTheWaitOfOneStep() {
        WaitBudget budget = new WaitBudget();
        for (int i = 0; i < 30; i++) {
            slow(budget).decide(SENSES);
        }
        long whole = budget.leftNanos();
        long spent = 0;
        for (BehaviourThread thread : threads) {
            long before = budget.leftNanos();
            assertEquals(new Decision.Go(Steering.STOP), thread.decide(SENSES));
            spent += before - budget.leftNanos();
        }
        assertTrue(spent > 0 && spent <= whole, spent + " of " + whole + " ns");
        budget.renew();
        assertEquals(whole, budget.leftNanos());
    }
}
