package simgsm.center.app;

import simgsm.event.EventLine;

/** Answer to {@code class}; score counts the passed steps of the latest lesson, and is empty before one. */
@EventLine("class number= name= robot= orders= collisions= lesson= score=")
public record ClassRow(
        String number, String name, String robot, int orders, int collisions, String lesson, String score) {}
