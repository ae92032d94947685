/**
 * The demo: starts centre, phone and SimRobot as processes and plays a session. Read {@link
 * simgsm.classroom.demo.HeadlessDemo} first.
 */
package simgsm.classroom.demo;
